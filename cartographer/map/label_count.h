// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_LABEL_COUNT_H_
#define CARTOGRAPHER_MAP_LABEL_COUNT_H_

#include <cstdint>
#include <vector>

#include "cartographer/map/map.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/submap.h"

namespace cartographer::map {

// How much of a map is of one label.
struct LabelCount {
  uint64_t hits = 0;           // in the submaps' grids
  uint64_t submap_points = 0;  // in their clouds
  uint64_t node_points = 0;    // in the nodes' clouds

  bool IsZero() const { return hits == 0 && submap_points == 0 && node_points == 0; }
};

// By label; as many entries as the label set has labels, which are those of all that is counted.
using LabelCounts = std::vector<LabelCount>;

void CountSubmap(const submap::Submap& submap, LabelCounts* counts);
void CountNode(const sensor::LabeledPointCloud& cloud, LabelCounts* counts);
LabelCounts CountMap(const Map& map);

// What `before` has more of than `after`, which has no more of anything (CHECKed).
LabelCounts Difference(const LabelCounts& before, const LabelCounts& after);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_LABEL_COUNT_H_
