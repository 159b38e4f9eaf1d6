// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_MAP_VIEW_H_
#define SEMANTIC_KISS_REPORT_MAP_VIEW_H_

#include <string>

#include "cartographer/map/map.h"
#include "semantic_kiss/report/map_layers.h"
#include "semantic_kiss/report/report.h"

namespace semantic_kiss::report {

// A map with what it tells of its drives itself: a path through the nodes of each trajectory, the
// first of them by height and speed, and a mark for each loop closure among the constraints whose
// node and submap the map holds.
MapView ViewOf(const cartographer::map::Map& map, MapLayers layers, const std::string& caption);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_MAP_VIEW_H_
