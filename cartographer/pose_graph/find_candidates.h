// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_FIND_CANDIDATES_H_
#define CARTOGRAPHER_POSE_GRAPH_FIND_CANDIDATES_H_

#include <vector>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/place_index.h"
#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "cartographer/pose_graph/topology.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/search_space.h"

namespace cartographer::pose_graph {

// A submap that a node may have been in again, and where in it to look.
struct ClosureCandidate {
  submap::NodeId node_id;
  submap::SubmapId submap_id;
  // Pose of the node's level frame in the submap's.
  scan_matching::PlanarPose submap_from_node_guess;
  scan_matching::SearchWindow window;
  bool by_place_recognition = false;
};

// How far the estimate of a node relative to a submap may be wrong when they are `path_m` of
// driving apart. May be infinite.
scan_matching::SearchWindow WindowAfter(double path_m, const proto::SearchWindowOptions& options);

// A finished submap that was not driven through just now, as seen from a node.
struct OtherVisit {
  submap::SubmapId submap_id;
  double path_m;  // Topology::PathsFrom(); infinite if nothing ties them
};

// The submaps that the node may revisit: the finished ones of other trajectories, and those of its
// own between whose middle node and this one `min_travel_m` or more was driven.
std::vector<OtherVisit> FindOtherVisits(const submap::NodeId& node_id, double min_travel_m,
                                        const Graph& graph, const Topology& topology);

// Those of them that are near by the map's estimate, nearest first, as far as its uncertainty
// allows to rely on it.
std::vector<ClosureCandidate> NearbyCandidates(const submap::NodeId& node_id,
                                               const std::vector<OtherVisit>& visits,
                                               const proto::CandidateOptions& options,
                                               const Graph& graph, const Topology& topology);

// Those of them that the estimate neither finds nor rules out: the node may be there, but where the
// window would be is too uncertain. These are what place recognition is asked about.
std::vector<submap::SubmapId> UncertainVisits(const submap::NodeId& node_id,
                                              const std::vector<OtherVisit>& visits,
                                              const proto::CandidateOptions& options,
                                              const Graph& graph, const Topology& topology);

// All of these submaps, to be searched at all headings around their middle nodes, as far as
// `options` say; of those near each other only the first one.
std::vector<ClosureCandidate> CandidatesEverywhere(const submap::NodeId& node_id,
                                                   const std::vector<submap::SubmapId>& among,
                                                   const proto::SearchAllOptions& options,
                                                   const Graph& graph, const Topology& topology);

// A proposal of place recognition, which compares submaps, as a candidate for a node of the submap
// that was asked for.
ClosureCandidate CandidateAtPlace(const submap::NodeId& node_id, const PlaceCandidate& place,
                                  const scan_matching::PlanarPose& query_from_node,
                                  const proto::CandidateOptions& options);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_FIND_CANDIDATES_H_
