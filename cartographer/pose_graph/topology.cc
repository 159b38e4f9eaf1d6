// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/topology.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;

// By submap, in the order of the constraints.
std::map<SubmapId, std::vector<NodeId>> MembersOf(const Graph& graph) {
  std::map<SubmapId, std::vector<NodeId>> members;
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind == Constraint::Kind::kIntraSubmap) {
      members[constraint.submap_id].push_back(constraint.node_id);
    }
  }
  return members;
}

}  // namespace

Topology::Topology(const Graph& graph) {
  for (auto& [submap_id, nodes] : MembersOf(graph)) {
    middle_node_.emplace(submap_id, nodes[nodes.size() / 2]);
    for (const NodeId& node_id : nodes) oldest_submap_.emplace(node_id, submap_id);
  }
  LinkTrajectories(graph);
  LinkClosures(graph);
}

void Topology::LinkTrajectories(const Graph& graph) {
  edges_.resize(graph.nodes.size());
  const NodeId* last_id = nullptr;
  Eigen::Vector3d last_position;
  for (const auto& [id, node] : graph.nodes) {
    const size_t index = driven_m_.size();
    index_of_node_.emplace_hint(index_of_node_.end(), id, index);
    const Eigen::Vector3d position = node.local_from_node.translation();
    if (last_id != nullptr && last_id->trajectory_id == id.trajectory_id) {
      const double step_m = (position - last_position).norm();
      driven_m_.push_back(driven_m_.back() + step_m);
      Link(index - 1, index, step_m);
    } else {
      driven_m_.push_back(0.);
    }
    last_id = &id;
    last_position = position;
  }
}

void Topology::LinkClosures(const Graph& graph) {
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind != Constraint::Kind::kInterSubmap) continue;
    const NodeId* const middle = MiddleNode(constraint.submap_id);
    const auto node = index_of_node_.find(constraint.node_id);
    if (middle == nullptr || node == index_of_node_.end()) continue;
    Link(index_of_node_.at(*middle), node->second, 0.);
  }
}

void Topology::Link(size_t a, size_t b, double length_m) {
  edges_[a].push_back({b, length_m});
  edges_[b].push_back({a, length_m});
}

double Topology::DrivenTo(const NodeId& node_id) const {
  const auto it = index_of_node_.find(node_id);
  CHECK(it != index_of_node_.end()) << node_id.trajectory_id << ", " << node_id.node_index;
  return driven_m_[it->second];
}

const NodeId* Topology::MiddleNode(const SubmapId& submap_id) const {
  const auto it = middle_node_.find(submap_id);
  return it == middle_node_.end() ? nullptr : &it->second;
}

const SubmapId* Topology::OldestSubmapOf(const NodeId& node_id) const {
  const auto it = oldest_submap_.find(node_id);
  return it == oldest_submap_.end() ? nullptr : &it->second;
}

std::map<SubmapId, double> Topology::PathsFrom(const NodeId& node_id) const {
  const auto from = index_of_node_.find(node_id);
  CHECK(from != index_of_node_.end()) << node_id.trajectory_id << ", " << node_id.node_index;
  const std::vector<double> length_m = ShortestPaths(from->second);
  std::map<SubmapId, double> paths;
  for (const auto& [submap_id, middle] : middle_node_) {
    const double path_m = length_m[index_of_node_.at(middle)];
    if (path_m < std::numeric_limits<double>::infinity()) paths.emplace(submap_id, path_m);
  }
  return paths;
}

// Dijkstra's algorithm.
std::vector<double> Topology::ShortestPaths(size_t from) const {
  using Front = std::pair<double, size_t>;
  std::vector<double> length_m(edges_.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Front, std::vector<Front>, std::greater<Front>> fronts;
  length_m[from] = 0.;
  fronts.push({0., from});
  while (!fronts.empty()) {
    const auto [reached_m, at] = fronts.top();
    fronts.pop();
    if (reached_m > length_m[at]) continue;
    for (const Edge& edge : edges_[at]) {
      const double beyond_m = reached_m + edge.length_m;
      if (beyond_m < length_m[edge.to]) {
        length_m[edge.to] = beyond_m;
        fronts.push({beyond_m, edge.to});
      }
    }
  }
  return length_m;
}

}  // namespace cartographer::pose_graph
