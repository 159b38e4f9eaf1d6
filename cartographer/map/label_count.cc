// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/label_count.h"

#include "glog/logging.h"

namespace cartographer::map {
namespace {

using Count = uint64_t LabelCount::*;
constexpr Count kCounts[] = {&LabelCount::hits, &LabelCount::submap_points,
                             &LabelCount::node_points};

void CountPoints(const sensor::LabeledPointCloud& cloud, Count count, LabelCounts* counts) {
  for (const sensor::Label label : cloud.labels) ++((*counts)[sensor::Index(label)].*count);
}

}  // namespace

void CountSubmap(const submap::Submap& submap, LabelCounts* counts) {
  for (const sensor::Label label : submap.grid.Labels()) {
    uint64_t& hits = (*counts)[sensor::Index(label)].hits;
    for (const auto& [index, tile] : submap.grid.LayerOf(label)) {
      for (const uint16_t count : tile->hits) hits += count;
    }
  }
  CountPoints(submap.cloud, &LabelCount::submap_points, counts);
}

void CountNode(const sensor::LabeledPointCloud& cloud, LabelCounts* counts) {
  CountPoints(cloud, &LabelCount::node_points, counts);
}

LabelCounts CountMap(const Map& map) {
  LabelCounts counts(map.labels.size());
  for (const auto& [id, placed] : map.submaps) CountSubmap(*placed.submap, &counts);
  for (const auto& [id, node] : map.nodes) CountNode(*node.cloud, &counts);
  return counts;
}

LabelCounts Difference(const LabelCounts& before, const LabelCounts& after) {
  CHECK_EQ(before.size(), after.size());
  LabelCounts difference(before.size());
  for (size_t i = 0; i < before.size(); ++i) {
    for (const Count count : kCounts) {
      CHECK_GE(before[i].*count, after[i].*count) << "label " << i;
      difference[i].*count = before[i].*count - after[i].*count;
    }
  }
  return difference;
}

}  // namespace cartographer::map
