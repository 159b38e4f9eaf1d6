// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/trim.h"

#include <algorithm>
#include <limits>
#include <set>

#include "cartographer/pose_graph/erase_keys.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;

// Constraints whose node or submap is gone.
void RemoveDangling(Graph* graph) {
  const auto dangles = [graph](const Constraint& constraint) {
    return graph->nodes.count(constraint.node_id) == 0 ||
           graph->submaps.count(constraint.submap_id) == 0;
  };
  graph->constraints.erase(
      std::remove_if(graph->constraints.begin(), graph->constraints.end(), dangles),
      graph->constraints.end());
}

}  // namespace

void TrimBefore(const NodeId& first_kept, Graph* graph) {
  const int trajectory_id = first_kept.trajectory_id;
  const auto is_before = [&](const NodeId& id) {
    return id.trajectory_id == trajectory_id && id.node_index < first_kept.node_index;
  };
  std::set<SubmapId> held;
  for (const Constraint& constraint : graph->constraints) {
    const bool inside = constraint.kind == Constraint::Kind::kIntraSubmap;
    if (inside && !is_before(constraint.node_id)) held.insert(constraint.submap_id);
  }
  EraseKeysIf(&graph->nodes, is_before);
  EraseKeysIf(&graph->submaps, [&](const SubmapId& id) {
    return id.trajectory_id == trajectory_id && held.count(id) == 0 &&
           graph->submaps.at(id).submap->finished;
  });
  RemoveDangling(graph);
}

void RemoveTrajectory(int trajectory_id, Graph* graph) {
  EraseKeysIf(&graph->nodes, [=](const NodeId& id) { return id.trajectory_id == trajectory_id; });
  EraseKeysIf(&graph->submaps,
              [=](const SubmapId& id) { return id.trajectory_id == trajectory_id; });
  RemoveDangling(graph);
}

}  // namespace cartographer::pose_graph
