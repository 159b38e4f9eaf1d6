// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/join_groups.h"

#include <algorithm>

#include "cartographer/pose_graph/trajectory_groups.h"
#include "cartographer/transform/rigid_transform.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

using transform::Rigid3d;

void MoveGroup(int group, const Rigid3d& new_from_old, TrajectoryGroups* groups, Graph* graph) {
  for (auto& [id, node] : graph->nodes) {
    if (groups->FirstOf(id.trajectory_id) != group) continue;
    node.map_from_node = new_from_old * node.map_from_node;
  }
  for (auto& [id, submap] : graph->submaps) {
    if (groups->FirstOf(id.trajectory_id) != group) continue;
    submap.map_from_submap = new_from_old * submap.map_from_submap;
  }
}

}  // namespace

bool JoinGroups(const submap::Constraint& closure, Graph* graph) {
  TrajectoryGroups groups(*graph);
  const int of_node = groups.FirstOf(closure.node_id.trajectory_id);
  const int of_submap = groups.FirstOf(closure.submap_id.trajectory_id);
  if (of_node == of_submap) return false;
  bool node_is_frozen = false, submap_is_frozen = false;
  for (const int id : graph->frozen_trajectories) {
    node_is_frozen |= groups.FirstOf(id) == of_node;
    submap_is_frozen |= groups.FirstOf(id) == of_submap;
  }
  if (node_is_frozen && submap_is_frozen) return false;

  const auto node = graph->nodes.find(closure.node_id);
  const auto submap = graph->submaps.find(closure.submap_id);
  CHECK(node != graph->nodes.end() && submap != graph->submaps.end());
  // Where the node should be, by where it is: tilts stay as gravity has them.
  const Rigid3d wanted =
      transform::Level(submap->second.map_from_submap * closure.submap_from_node);
  const Rigid3d present = transform::Level(node->second.map_from_node);
  const bool moves_node = submap_is_frozen || (!node_is_frozen && of_node > of_submap);
  if (moves_node) {
    MoveGroup(of_node, wanted * present.inverse(), &groups, graph);
  } else {
    MoveGroup(of_submap, present * wanted.inverse(), &groups, graph);
  }
  return true;
}

}  // namespace cartographer::pose_graph
