// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_POSE_GRAPH_SMALL_DRIVE_H_
#define TEST_CARTOGRAPHER_POSE_GRAPH_SMALL_DRIVE_H_

#include <memory>
#include <vector>

#include "cartographer/pose_graph/graph.h"

namespace cartographer::pose_graph {

// Adds a trajectory with a node at each of the poses, where the odometry has them too, and an empty
// finished submap for every `nodes_per_submap` nodes in a row, at the pose of its first.
inline void AddDrive(int trajectory_id, const std::vector<transform::Rigid3d>& poses,
                     int nodes_per_submap, Graph* graph) {
  for (int i = 0; i < static_cast<int>(poses.size()); ++i) {
    const submap::NodeId node_id{trajectory_id, i};
    graph->nodes[node_id] = {common::FromUnixSeconds(0.1 * i), poses[i], poses[i],
                             std::make_shared<const sensor::LabeledPointCloud>()};
    const int first = i / nodes_per_submap * nodes_per_submap;
    const submap::SubmapId submap_id{trajectory_id, i / nodes_per_submap};
    if (i == first) {
      auto submap = std::make_shared<submap::Submap>(0.2);
      submap->local_from_submap = poses[i];
      submap->finished = true;
      graph->submaps[submap_id] = {poses[i], submap};
    }
    submap::Constraint constraint;
    constraint.submap_id = submap_id;
    constraint.node_id = node_id;
    constraint.submap_from_node = poses[first].inverse() * poses[i];
    graph->constraints.push_back(constraint);
  }
}

// Poses a metre apart: out along x for `length_m`, and back beside it at y = `lane_m`.
inline std::vector<transform::Rigid3d> OutAndBack(int length_m, double lane_m) {
  std::vector<transform::Rigid3d> poses;
  for (int x = 0; x <= length_m; ++x) {
    poses.push_back(transform::Rigid3d::Translation({1. * x, 0., 0.}));
  }
  const Eigen::Quaterniond turned(0., 0., 0., 1.);
  for (int x = length_m; x >= 0; --x) poses.push_back({{1. * x, lane_m, 0.}, turned});
  return poses;
}

inline submap::Constraint ClosureBetween(const submap::SubmapId& submap_id,
                                         const submap::NodeId& node_id,
                                         const transform::Rigid3d& map_from_node,
                                         const Graph& graph) {
  submap::Constraint closure;
  closure.kind = submap::Constraint::Kind::kInterSubmap;
  closure.submap_id = submap_id;
  closure.node_id = node_id;
  closure.submap_from_node = graph.submaps.at(submap_id).map_from_submap.inverse() * map_from_node;
  return closure;
}

}  // namespace cartographer::pose_graph

#endif  // TEST_CARTOGRAPHER_POSE_GRAPH_SMALL_DRIVE_H_
