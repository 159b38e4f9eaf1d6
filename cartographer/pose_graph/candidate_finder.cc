// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/candidate_finder.h"

#include <algorithm>
#include <cmath>

#include "cartographer/common/parallel.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/transform/rigid_transform.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using submap::SubmapId;

// What `find` says of each node, put together in their order.
template <typename Find>
std::vector<ClosureCandidate> ForEachNode(const std::vector<NodeId>& node_ids, const Find& find) {
  std::vector<std::vector<ClosureCandidate>> by_node(node_ids.size());
  common::ParallelChunks(node_ids.size(), 1,
                         [&](size_t i, size_t) { by_node[i] = find(node_ids[i]); });
  std::vector<ClosureCandidate> candidates;
  for (const auto& of_node : by_node) {
    candidates.insert(candidates.end(), of_node.begin(), of_node.end());
  }
  return candidates;
}

}  // namespace

void CandidateFinder::Describe(const Graph& graph, const Topology& topology) {
  std::vector<SubmapId> ids;
  for (const auto& [id, placed] : graph.submaps) {
    if (!placed.submap->finished || topology.MiddleNode(id) == nullptr) continue;
    if (described_.insert(id).second) ids.push_back(id);
  }
  std::vector<PlaceDescriptor> descriptors(ids.size());
  common::ParallelChunks(ids.size(), 1, [&](size_t i, size_t) {
    descriptors[i] = DescribeOne(ids[i], graph, topology);
  });
  for (size_t i = 0; i < ids.size(); ++i) places_.Add(ids[i], descriptors[i]);
}

void CandidateFinder::Forget(const Graph& graph) {
  for (auto it = described_.begin(); it != described_.end();) {
    if (graph.submaps.count(*it) > 0) {
      ++it;
      continue;
    }
    places_.Remove(*it);
    it = described_.erase(it);
  }
}

PlaceDescriptor CandidateFinder::DescribeOne(const SubmapId& submap_id, const Graph& graph,
                                             const Topology& topology) const {
  const submap::PlacedSubmap& placed = graph.submaps.at(submap_id);
  const submap::PlacedNode& middle = graph.nodes.at(*topology.MiddleNode(submap_id));
  const transform::Rigid3d submap_from_middle =
      placed.map_from_submap.inverse() * middle.map_from_node;
  return describer_.Describe({{placed.submap->cloud, transform::Rigid3d::Identity()}},
                             submap_from_middle.translation().head<2>());
}

std::vector<OtherVisit> CandidateFinder::VisitsOf(const NodeId& node_id, const Graph& graph,
                                                  const Topology& topology) const {
  std::vector<OtherVisit> visits =
      FindOtherVisits(node_id, options_.min_travel_m(), graph, topology);
  if (settled_.count(node_id.trajectory_id) > 0) {
    const auto is_settled = [this](const OtherVisit& visit) {
      return settled_.count(visit.submap_id.trajectory_id) > 0;
    };
    visits.erase(std::remove_if(visits.begin(), visits.end(), is_settled), visits.end());
  }
  const auto expected_m = expected_m_.find(node_id.trajectory_id);
  if (expected_m == expected_m_.end()) return visits;
  for (OtherVisit& visit : visits) {
    if (std::isinf(visit.path_m)) visit.path_m = expected_m->second + topology.DrivenTo(node_id);
  }
  return visits;
}

std::vector<ClosureCandidate> CandidateFinder::Nearby(const std::vector<NodeId>& node_ids,
                                                      const Graph& graph,
                                                      const Topology& topology) const {
  return ForEachNode(node_ids, [&](const NodeId& id) {
    return NearbyCandidates(id, VisitsOf(id, graph, topology), options_, graph, topology);
  });
}

std::vector<ClosureCandidate> CandidateFinder::ByPlace(const std::vector<NodeId>& node_ids,
                                                       const Graph& graph,
                                                       const Topology& topology) const {
  return ForEachNode(node_ids, [&](const NodeId& id) { return PlacesOf(id, graph, topology); });
}

std::vector<ClosureCandidate> CandidateFinder::Everywhere(const NodeId& node_id, const Graph& graph,
                                                          const Topology& topology) const {
  return CandidatesEverywhere(node_id, Uncertain(node_id, graph, topology), options_.search_all(),
                              graph, topology);
}

std::vector<SubmapId> CandidateFinder::Uncertain(const NodeId& node_id, const Graph& graph,
                                                 const Topology& topology) const {
  return UncertainVisits(node_id, VisitsOf(node_id, graph, topology), options_, graph, topology);
}

std::vector<ClosureCandidate> CandidateFinder::PlacesOf(const NodeId& node_id, const Graph& graph,
                                                        const Topology& topology) const {
  const std::vector<SubmapId> among = Uncertain(node_id, graph, topology);
  if (among.empty()) return {};
  // Place recognition compares submaps, which show more than a scan: the node's own stands for it.
  const SubmapId& own_id = *CHECK_NOTNULL(topology.OldestSubmapOf(node_id));
  const scan_matching::PlanarPose own_from_node =
      scan_matching::InPlane(graph.submaps.at(own_id).submap->local_from_submap.inverse() *
                             transform::Level(graph.nodes.at(node_id).local_from_node));
  const std::set<SubmapId> allowed(among.begin(), among.end());
  std::vector<ClosureCandidate> candidates;
  for (const PlaceCandidate& place :
       places_.Find(DescribeOne(own_id, graph, topology), options_.max_places(),
                    [&](const SubmapId& id) { return allowed.count(id) > 0; })) {
    candidates.push_back(CandidateAtPlace(node_id, place, own_from_node, options_));
  }
  return candidates;
}

}  // namespace cartographer::pose_graph
