// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_TOPOLOGY_H_
#define CARTOGRAPHER_POSE_GRAPH_TOPOLOGY_H_

#include <map>
#include <vector>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/submap/id.h"

namespace cartographer::pose_graph {

// How the vertices of a graph hang together, and by how many metres of driving: what tells a
// revisit from a place just left, and how far the estimate of a node may be wrong. A snapshot of
// the graph.
class Topology {
 public:
  explicit Topology(const Graph& graph);

  // The way driven from the first node of its trajectory to the node [m]. CHECKs that it exists.
  double DrivenTo(const submap::NodeId& node_id) const;

  // The node in the middle of those whose scans are in the submap, where it shows most; nullptr for
  // a submap without nodes.
  const submap::NodeId* MiddleNode(const submap::SubmapId& submap_id) const;

  // The oldest of the submaps that took the node's scan; nullptr if none did.
  const submap::SubmapId* OldestSubmapOf(const submap::NodeId& node_id) const;

  // The way [m] of the shortest chain from a node to the middle node of each submap, along
  // trajectories in both directions and across loop closures, which count nothing. What cannot be
  // reached is left out.
  std::map<submap::SubmapId, double> PathsFrom(const submap::NodeId& node_id) const;

 private:
  struct Edge {
    size_t to;
    double length_m;
  };
  void LinkTrajectories(const Graph& graph);
  void LinkClosures(const Graph& graph);
  void Link(size_t a, size_t b, double length_m);
  std::vector<double> ShortestPaths(size_t from) const;

  std::map<submap::NodeId, size_t> index_of_node_;
  std::vector<double> driven_m_;
  std::vector<std::vector<Edge>> edges_;
  std::map<submap::SubmapId, submap::NodeId> middle_node_;
  std::map<submap::NodeId, submap::SubmapId> oldest_submap_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_TOPOLOGY_H_
