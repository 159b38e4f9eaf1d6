// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_FILTER_REPORT_H_
#define CARTOGRAPHER_MAP_FILTER_REPORT_H_

#include <string>

#include "cartographer/map/label_count.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/map/remove_trajectories.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::map {

// What a filter took out of a map.
struct FilterReport {
  LabelCounts labels;         // by label; those of removed trajectories included
  ElementCount trajectories;  // elements of trajectories that were removed as a whole

  bool IsEmpty() const;
};

// What was asked for and what was removed, in one line without line breaks, for the map's history:
//   filter --remove=car --min_hits=3: removed 120 hits, 8 submap points, 15 node points of car; ...
std::string HistoryLine(const proto::FilterOptions& options, const FilterReport& report,
                        const sensor::LabelSet& labels);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_FILTER_REPORT_H_
