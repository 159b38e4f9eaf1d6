// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/trajectory_groups.h"

#include <algorithm>

namespace cartographer::pose_graph {

TrajectoryGroups::TrajectoryGroups(const Graph& graph) {
  for (const submap::Constraint& constraint : graph.constraints) {
    if (constraint.kind != submap::Constraint::Kind::kInterSubmap) continue;
    Unite(constraint.node_id.trajectory_id, constraint.submap_id.trajectory_id);
  }
}

int TrajectoryGroups::FirstOf(int trajectory_id) {
  const auto it = parent_.emplace(trajectory_id, trajectory_id).first;
  if (it->second == trajectory_id) return trajectory_id;
  return it->second = FirstOf(it->second);
}

void TrajectoryGroups::Unite(int a, int b) {
  const int first_of_a = FirstOf(a);
  const int first_of_b = FirstOf(b);
  parent_[std::max(first_of_a, first_of_b)] = std::min(first_of_a, first_of_b);
}

}  // namespace cartographer::pose_graph
