// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_GRAPH_H_
#define CARTOGRAPHER_POSE_GRAPH_GRAPH_H_

#include <map>
#include <set>
#include <vector>

#include "cartographer/submap/constraint.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/placed.h"

namespace cartographer::pose_graph {

// What is optimized, as a plain value: nodes and submaps as the vertices, and what ties them.
// Consecutive nodes of a trajectory are tied by the odometry, too: by their local_from_node.
struct Graph {
  std::map<submap::SubmapId, submap::PlacedSubmap> submaps;
  std::map<submap::NodeId, submap::PlacedNode> nodes;
  std::vector<submap::Constraint> constraints;
  // Trajectories of a loaded map: they stay where they are.
  std::set<int> frozen_trajectories;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_GRAPH_H_
