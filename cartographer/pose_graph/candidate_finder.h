// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_CANDIDATE_FINDER_H_
#define CARTOGRAPHER_POSE_GRAPH_CANDIDATE_FINDER_H_

#include <map>
#include <set>
#include <vector>

#include "cartographer/pose_graph/find_candidates.h"
#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/place_descriptor.h"
#include "cartographer/pose_graph/place_index.h"
#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "cartographer/pose_graph/topology.h"

namespace cartographer::pose_graph {

// Proposes pairs of nodes and submaps: by the map's estimate, and by what places look like.
// Parallel inside; the results do not depend on the number of threads.
class CandidateFinder {
 public:
  CandidateFinder(const proto::CandidateOptions& options, const PlaceDescriber& describer)
      : options_(options), describer_(describer), places_(describer) {}

  // Takes in the submaps that were finished since the last call.
  void Describe(const Graph& graph, const Topology& topology);
  // Forgets the submaps that are not in the graph any more.
  void Forget(const Graph& graph);

  // From now on a trajectory that nothing ties to others counts as if a chain of so many metres
  // did: somebody knows about where it began.
  void ExpectNear(int trajectory_id, double path_m) { expected_m_[trajectory_id] = path_m; }

  // Between these trajectories all closures are known already: no pair of them is proposed.
  void Settle(const std::set<int>& trajectory_ids) { settled_ = trajectory_ids; }

  // For each node in turn: the submaps near where the map has it.
  std::vector<ClosureCandidate> Nearby(const std::vector<submap::NodeId>& node_ids,
                                       const Graph& graph, const Topology& topology) const;
  // For each node in turn: the submaps that look like its own, which must be finished,
  // among those that the estimate neither finds nor rules out.
  std::vector<ClosureCandidate> ByPlace(const std::vector<submap::NodeId>& node_ids,
                                        const Graph& graph, const Topology& topology) const;
  // For one node: all of the map, as far as the estimate neither finds the node nor rules it out.
  std::vector<ClosureCandidate> Everywhere(const submap::NodeId& node_id, const Graph& graph,
                                           const Topology& topology) const;

 private:
  // In ascending order.
  std::vector<submap::SubmapId> Uncertain(const submap::NodeId& node_id, const Graph& graph,
                                          const Topology& topology) const;
  std::vector<OtherVisit> VisitsOf(const submap::NodeId& node_id, const Graph& graph,
                                   const Topology& topology) const;
  std::vector<ClosureCandidate> PlacesOf(const submap::NodeId& node_id, const Graph& graph,
                                         const Topology& topology) const;
  PlaceDescriptor DescribeOne(const submap::SubmapId& submap_id, const Graph& graph,
                              const Topology& topology) const;

  const proto::CandidateOptions options_;
  const PlaceDescriber describer_;
  PlaceIndex places_;
  std::set<submap::SubmapId> described_;
  std::map<int, double> expected_m_;
  std::set<int> settled_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_CANDIDATE_FINDER_H_
