// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graph_selection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "cartographer/pose_graph/trajectory_groups.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;

std::map<SubmapId, SubmapTie> FindTies(const Graph& graph) {
  std::map<SubmapId, std::map<NodeId, const Constraint*>> nodes_of;
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind != Constraint::Kind::kIntraSubmap) continue;
    if (graph.frozen_trajectories.count(constraint.submap_id.trajectory_id) > 0) continue;
    if (graph.nodes.count(constraint.node_id) == 0) continue;
    if (graph.submaps.count(constraint.submap_id) == 0) continue;
    nodes_of[constraint.submap_id][constraint.node_id] = &constraint;
  }
  std::map<SubmapId, SubmapTie> ties;
  for (const auto& [submap_id, nodes] : nodes_of) {
    const auto middle = std::next(nodes.begin(), nodes.size() / 2);
    ties.emplace(submap_id, SubmapTie{middle->first, middle->second->submap_from_node});
  }
  return ties;
}

bool IsFinite(const Constraint& constraint) {
  if (!constraint.submap_from_node.IsFinite()) return false;
  if (constraint.information.has_value()) return constraint.information->allFinite();
  return std::isfinite(constraint.translation_weight) && std::isfinite(constraint.rotation_weight);
}

// The trajectories of which a pose is not finite.
std::set<int> FindBroken(const Graph& graph) {
  std::set<int> broken;
  for (const auto& [id, node] : graph.nodes) {
    if (!node.local_from_node.IsFinite() || !node.map_from_node.IsFinite()) {
      broken.insert(id.trajectory_id);
    }
  }
  for (const auto& [id, submap] : graph.submaps) {
    if (!submap.map_from_submap.IsFinite()) broken.insert(id.trajectory_id);
  }
  return broken;
}

std::vector<const Constraint*> FindLoops(const Graph& graph,
                                         const std::map<SubmapId, SubmapTie>& ties) {
  const std::set<int> broken = FindBroken(graph);
  const auto is_frozen = [&graph](int id) { return graph.frozen_trajectories.count(id) > 0; };
  std::vector<const Constraint*> loops;
  for (const Constraint& constraint : graph.constraints) {
    const int of_node = constraint.node_id.trajectory_id;
    const int of_submap = constraint.submap_id.trajectory_id;
    if (constraint.kind != Constraint::Kind::kInterSubmap || !IsFinite(constraint)) continue;
    if (broken.count(of_node) > 0 || broken.count(of_submap) > 0) continue;
    if (graph.nodes.count(constraint.node_id) == 0) continue;
    if (graph.submaps.count(constraint.submap_id) == 0) continue;
    if (is_frozen(of_node) && is_frozen(of_submap)) continue;
    if (!is_frozen(of_submap) && ties.count(constraint.submap_id) == 0) continue;
    loops.push_back(&constraint);
  }
  return loops;
}

}  // namespace

GraphSelection SelectFrom(const Graph& graph) {
  GraphSelection selection;
  selection.ties = FindTies(graph);
  selection.loops = FindLoops(graph, selection.ties);
  TrajectoryGroups groups;
  for (const Constraint* loop : selection.loops) {
    const int of_node = loop->node_id.trajectory_id;
    const int of_submap = loop->submap_id.trajectory_id;
    groups.Unite(of_node, of_submap);
    for (const int id : {of_node, of_submap}) {
      if (graph.frozen_trajectories.count(id) == 0) selection.moving.insert(id);
    }
  }
  std::set<int> held;
  for (const int id : graph.frozen_trajectories) held.insert(groups.FirstOf(id));
  for (const int id : selection.moving) {
    if (held.insert(groups.FirstOf(id)).second) selection.anchored.insert(id);
  }
  return selection;
}

}  // namespace cartographer::pose_graph
