// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_TRAJECTORY_GROUPS_H_
#define CARTOGRAPHER_POSE_GRAPH_TRAJECTORY_GROUPS_H_

#include <map>

#include "cartographer/pose_graph/graph.h"

namespace cartographer::pose_graph {

// Which trajectories are tied to each other, directly or through others. A group is named by the
// smallest id in it.
class TrajectoryGroups {
 public:
  TrajectoryGroups() = default;
  // As the loop closures of a graph tie them.
  explicit TrajectoryGroups(const Graph& graph);

  // A trajectory that was not heard of before is a group of its own.
  int FirstOf(int trajectory_id);
  void Unite(int a, int b);

 private:
  std::map<int, int> parent_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_TRAJECTORY_GROUPS_H_
