// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_MAP_VISITED_MAP_H_
#define TEST_CARTOGRAPHER_MAP_VISITED_MAP_H_

#include "cartographer/map/map.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "test/testing/map_sketch.h"

namespace cartographer::map {

// One submap with one node, at the same place as all others unless it says otherwise.
struct VisitingSubmap {
  double time_s = 0.;
  // Cells of 1 m with 10 hits each, the lower left one at (0, 0); 'c' is a car above the road: 10
  // hits of each.
  semantic_kiss_testing::Sketch sketch;
  int trajectory_id = 0;
  transform::Rigid3d map_from_submap = {};
};

// Adds it as the next submap and node of its trajectory.
inline void AddVisitingSubmap(const VisitingSubmap& visiting, Map* map) {
  constexpr int kHits = 10;
  semantic_kiss_testing::Sketch things = visiting.sketch;
  const auto submap = semantic_kiss_testing::SubmapFromSketch(
      [&things] {
        for (std::string& row : things) {
          for (char& character : row) character = character == 'c' ? 'C' : character;
        }
        return things;
      }(),
      1., kHits);
  for (size_t row = 0; row < visiting.sketch.size(); ++row) {
    const int y = static_cast<int>(visiting.sketch.size() - 1 - row);
    for (size_t x = 0; x < visiting.sketch[row].size(); ++x) {
      if (visiting.sketch[row][x] != 'c') continue;
      submap->grid.AddHits(semantic_kiss_testing::SketchLabel("road"), {static_cast<int>(x), y},
                           kHits);
    }
  }
  int index = 0;
  while (map->submaps.count({visiting.trajectory_id, index}) > 0) ++index;
  map->submaps[{visiting.trajectory_id, index}] = {visiting.map_from_submap, submap};
  MapNode& node = map->nodes[{visiting.trajectory_id, index}];
  node.time = common::FromUnixSeconds(visiting.time_s);
  node.map_from_node = visiting.map_from_submap;
  node.cloud = std::make_shared<sensor::LabeledPointCloud>();
  Constraint constraint;
  constraint.submap_id = {visiting.trajectory_id, index};
  constraint.node_id = {visiting.trajectory_id, index};
  map->constraints.push_back(constraint);
}

inline Map VisitedMap(const std::vector<VisitingSubmap>& submaps) {
  Map map = semantic_kiss_testing::EmptyMap();
  for (const VisitingSubmap& submap : submaps) AddVisitingSubmap(submap, &map);
  return map;
}

// Visits are 30 s apart; a cell is judged by itself.
inline proto::TransientOptions SharpTransientOptions() {
  proto::TransientOptions options;
  options.set_min_time_between_visits_s(30.);
  options.set_tolerance_m(0.);
  options.set_min_ground_hits(2);
  options.set_max_movable_share(0.1);
  options.set_max_height_difference_m(3.);
  return options;
}

// The hits of a label as a sketch: '#' where there are some.
inline semantic_kiss_testing::Sketch HitsOf(const char* label, const Map& map,
                                            const submap::SubmapId& id, int width, int height) {
  semantic_kiss_testing::Sketch sketch(height, std::string(width, '.'));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int hits =
          map.submaps.at(id).submap->grid.Hits(semantic_kiss_testing::SketchLabel(label), {x, y});
      if (hits > 0) sketch[height - 1 - y][x] = '#';
    }
  }
  return sketch;
}

}  // namespace cartographer::map

#endif  // TEST_CARTOGRAPHER_MAP_VISITED_MAP_H_
