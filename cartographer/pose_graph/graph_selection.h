// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_GRAPH_SELECTION_H_
#define CARTOGRAPHER_POSE_GRAPH_GRAPH_SELECTION_H_

#include <map>
#include <set>
#include <vector>

#include "cartographer/pose_graph/graph.h"

namespace cartographer::pose_graph {

// The node that a submap hangs on.
struct SubmapTie {
  submap::NodeId node_id;
  transform::Rigid3d submap_from_node;
};

// What an optimization is about.
struct GraphSelection {
  // Loop constraints that say something: finite, between a node and a submap that exist, at least
  // one of which can move. They point into the graph.
  std::vector<const submap::Constraint*> loops;
  // Trajectories that loops tie to anything, themselves included, and that are not frozen.
  std::set<int> moving;
  // Of those, the ones whose first node stays, so that something does: the first of each group that
  // loops tie together, unless a frozen trajectory is in the group.
  std::set<int> anchored;
  // For each submap of a trajectory that is not frozen: the middle one of its nodes.
  std::map<submap::SubmapId, SubmapTie> ties;
};

GraphSelection SelectFrom(const Graph& graph);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_GRAPH_SELECTION_H_
