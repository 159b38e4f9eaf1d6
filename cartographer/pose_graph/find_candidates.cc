// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/find_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {
namespace {

using scan_matching::PlanarPose;
using scan_matching::SearchWindow;
using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;

constexpr double kRadPerDeg = M_PI / 180.;

// The node's pose in a submap as seen from above, roll and pitch of both left out.
PlanarPose EstimateInPlane(const Graph& graph, const NodeId& node_id, const SubmapId& submap_id) {
  const Rigid3d& map_from_node = graph.nodes.at(node_id).map_from_node;
  const Rigid3d& map_from_submap = graph.submaps.at(submap_id).map_from_submap;
  return scan_matching::InPlane(map_from_submap.inverse() * transform::Level(map_from_node));
}

// From the node to the middle of the submap, as seen from above.
double PlanarDistance(const NodeId& node_id, const SubmapId& submap_id, const Graph& graph,
                      const Topology& topology) {
  const NodeId& middle = *topology.MiddleNode(submap_id);
  const Eigen::Vector3d offset = graph.nodes.at(middle).map_from_node.translation() -
                                 graph.nodes.at(node_id).map_from_node.translation();
  return offset.head<2>().norm();
}

}  // namespace

SearchWindow WindowAfter(double path_m, const proto::SearchWindowOptions& options) {
  return {options.linear_m() + options.linear_m_per_m() * path_m,
          kRadPerDeg * std::min(options.max_angular_deg(),
                                options.angular_deg() + options.angular_deg_per_m() * path_m)};
}

std::vector<OtherVisit> FindOtherVisits(const NodeId& node_id, double min_travel_m,
                                        const Graph& graph, const Topology& topology) {
  const std::map<SubmapId, double> paths = topology.PathsFrom(node_id);
  std::vector<OtherVisit> visits;
  for (const auto& [submap_id, placed] : graph.submaps) {
    const NodeId* const middle = topology.MiddleNode(submap_id);
    if (!placed.submap->finished || middle == nullptr) continue;
    if (middle->trajectory_id == node_id.trajectory_id &&
        std::abs(topology.DrivenTo(node_id) - topology.DrivenTo(*middle)) < min_travel_m) {
      continue;
    }
    const auto path = paths.find(submap_id);
    visits.push_back(
        {submap_id, path == paths.end() ? std::numeric_limits<double>::infinity() : path->second});
  }
  return visits;
}

std::vector<ClosureCandidate> NearbyCandidates(const NodeId& node_id,
                                               const std::vector<OtherVisit>& visits,
                                               const proto::CandidateOptions& options,
                                               const Graph& graph, const Topology& topology) {
  std::vector<std::pair<double, ClosureCandidate>> by_distance;
  for (const OtherVisit& visit : visits) {
    const SearchWindow window = WindowAfter(visit.path_m, options.window());
    if (window.linear_m > options.window().max_linear_m()) continue;
    const double distance_m = PlanarDistance(node_id, visit.submap_id, graph, topology);
    if (distance_m > options.max_distance_m() + window.linear_m) continue;
    by_distance.push_back({distance_m,
                           {node_id, visit.submap_id,
                            EstimateInPlane(graph, node_id, visit.submap_id), window, false}});
  }
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ClosureCandidate> candidates;
  for (const auto& [distance_m, candidate] : by_distance) {
    if (candidates.size() == static_cast<size_t>(options.max_nearby())) break;
    candidates.push_back(candidate);
  }
  return candidates;
}

std::vector<SubmapId> UncertainVisits(const NodeId& node_id, const std::vector<OtherVisit>& visits,
                                      const proto::CandidateOptions& options, const Graph& graph,
                                      const Topology& topology) {
  std::vector<SubmapId> uncertain;
  for (const OtherVisit& visit : visits) {
    const SearchWindow window = WindowAfter(visit.path_m, options.window());
    if (window.linear_m <= options.place_window_above_m()) continue;
    if (PlanarDistance(node_id, visit.submap_id, graph, topology) >
        options.max_distance_m() + window.linear_m) {
      continue;
    }
    uncertain.push_back(visit.submap_id);
  }
  return uncertain;
}

std::vector<ClosureCandidate> CandidatesEverywhere(const NodeId& node_id,
                                                   const std::vector<SubmapId>& among,
                                                   const proto::SearchAllOptions& options,
                                                   const Graph& graph, const Topology& topology) {
  std::vector<Eigen::Vector2d> middles;
  std::vector<ClosureCandidate> candidates;
  for (const SubmapId& submap_id : among) {
    const NodeId& middle = *topology.MiddleNode(submap_id);
    const Eigen::Vector2d position = graph.nodes.at(middle).map_from_node.translation().head<2>();
    const auto is_near = [&](const Eigen::Vector2d& other) {
      return (other - position).norm() < options.linear_m() / 2.;
    };
    if (std::any_of(middles.begin(), middles.end(), is_near)) continue;
    middles.push_back(position);
    candidates.push_back({node_id, submap_id, EstimateInPlane(graph, middle, submap_id),
                          SearchWindow{options.linear_m(), M_PI}, true});
  }
  return candidates;
}

ClosureCandidate CandidateAtPlace(const NodeId& node_id, const PlaceCandidate& place,
                                  const PlanarPose& query_from_node,
                                  const proto::CandidateOptions& options) {
  ClosureCandidate candidate;
  candidate.node_id = node_id;
  candidate.submap_id = place.submap_id;
  candidate.submap_from_node_guess = scan_matching::InPlane(
      scan_matching::InSpace(place.submap_from_query) * scan_matching::InSpace(query_from_node));
  candidate.window = {options.place_linear_m(), kRadPerDeg * options.place_angular_deg()};
  candidate.by_place_recognition = true;
  return candidate;
}

}  // namespace cartographer::pose_graph
