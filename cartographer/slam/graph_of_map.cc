// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/graph_of_map.h"

#include <utility>

#include "cartographer/map/trajectories.h"

namespace cartographer::slam {

pose_graph::Graph GraphOf(const map::Map& map) {
  pose_graph::Graph graph;
  graph.submaps = map.submaps;
  graph.nodes = map.nodes;
  graph.constraints = map.constraints;
  return graph;
}

pose_graph::Graph FrozenGraphOf(const map::Map& map) {
  pose_graph::Graph graph = GraphOf(map);
  graph.frozen_trajectories = map::TrajectoriesOf(map);
  for (auto& [id, node] : graph.nodes) node.local_from_node = node.map_from_node;
  return graph;
}

map::Map MapOf(pose_graph::Graph graph, const sensor::LabelSet& labels) {
  map::Map map;
  map.submaps = std::move(graph.submaps);
  map.nodes = std::move(graph.nodes);
  map.constraints = std::move(graph.constraints);
  map.labels = labels;
  return map;
}

int NextTrajectoryId(const map::Map& map) {
  const std::set<int> ids = map::TrajectoriesOf(map);
  return ids.empty() ? 0 : *ids.rbegin() + 1;
}

}  // namespace cartographer::slam
