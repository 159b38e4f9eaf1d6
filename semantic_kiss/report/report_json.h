// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_REPORT_JSON_H_
#define SEMANTIC_KISS_REPORT_REPORT_JSON_H_

#include <nlohmann/json.hpp>

#include "semantic_kiss/report/report.h"

namespace semantic_kiss::report {

// What the page's scripts draw from, positions in metres to the centimetre:
//   maps: [{caption, frame {min_x, max_y, resolution, width, height}, halvings, tile_side,
//           layers: [{name, group, color "#rrggbb", tiles {"level/column/row": data URI}}],
//           paths: [{name, role, x, y}], colorings: [{name, unit, values}],
//           closure_facts, closures: [{node, submap, right, facts}],
//           rejected_facts, rejected: as closures}]
//   charts: [{kind, heading, x_name, y_name, x, categories, series [{name, role, values}],
//             along_path}]
// Roles are "trajectory", "odometry", "truth", "earlier"; kinds are "line", "columns", "rows". What
// is not finite becomes null.
nlohmann::ordered_json ReportJson(const Report& report);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_REPORT_JSON_H_
