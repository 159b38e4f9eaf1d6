// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/closure_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cartographer/common/parallel.h"
#include "cartographer/pose_graph/trajectory_groups.h"
#include "cartographer/pose_graph/verify_closure.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/refine_in_plane.h"
#include "cartographer/scan_matching/submap_matcher.h"
#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

using scan_matching::Match;
using scan_matching::MatchingScan;
using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;

// What candidates share (a node's scan, a submap's surfaces) is made once for as many as this, and
// then dropped: neighbours come one after the other, and memory stays bounded.
constexpr size_t kCandidatesAtOnce = 64;

// What a match in the plane leaves open, so wide that it hardly pulls.
constexpr double kUnseenHeight_m = 10.;
constexpr double kUnseenTilt_rad = 0.2;

constexpr size_t kBytesPerMiB = size_t{1} << 20;

// What turns the node's frame upright, by the odometry's idea of upright.
Rigid3d LevelFromNode(const submap::PlacedNode& node) {
  return transform::Level(node.local_from_node).inverse() * node.local_from_node;
}

// What turns the node's frame upright in the submap's, by the map's idea of both.
Rigid3d LevelFromNode(const submap::PlacedNode& node, const submap::PlacedSubmap& submap) {
  const Rigid3d submap_from_node = submap.map_from_submap.inverse() * node.map_from_node;
  return transform::Level(submap_from_node).inverse() * submap_from_node;
}

// The same where nothing ties the node to the submap, so that their ideas of upright, which are
// those of the first scans of their drives, may differ: as the submap's own drive stood nearby, on
// the same ground.
Rigid3d LevelFromVisitor(const Rigid3d& submap_from_level, const SubmapId& submap_id,
                         const Graph& graph) {
  const Rigid3d submap_from_map = graph.submaps.at(submap_id).map_from_submap.inverse();
  Rigid3d nearest;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const submap::Constraint& constraint : graph.constraints) {
    if (constraint.kind != submap::Constraint::Kind::kIntraSubmap) continue;
    if (!(constraint.submap_id == submap_id)) continue;
    const Rigid3d host = submap_from_map * graph.nodes.at(constraint.node_id).map_from_node;
    const double distance_m =
        (host.translation() - submap_from_level.translation()).head<2>().norm();
    if (distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    nearest = host;
  }
  if (std::isinf(nearest_m)) return Rigid3d::Identity();
  const double turn =
      transform::Yaw(submap_from_level.rotation()) - transform::Yaw(nearest.rotation());
  const Eigen::Quaterniond turned =
      nearest.rotation() * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
  return Rigid3d({0., 0., 0.}, submap_from_level.rotation().inverse() * turned);
}

sensor::LabeledPointCloud Moved(sensor::LabeledPointCloud cloud, const Rigid3d& to_from_cloud) {
  for (Eigen::Vector3f& position : cloud.positions) {
    position = (to_from_cloud * position.cast<double>().eval()).cast<float>();
  }
  return cloud;
}

// An entry for each of the keys, made in parallel.
template <typename Key, typename Value, typename Make>
std::map<Key, std::shared_ptr<const Value>> MakeForEach(
    std::map<Key, std::shared_ptr<const Value>> entries, const Make& make) {
  std::vector<std::pair<const Key, std::shared_ptr<const Value>>*> list;
  for (auto& entry : entries) list.push_back(&entry);
  common::ParallelChunks(list.size(), 1,
                         [&](size_t i, size_t) { list[i]->second = make(list[i]->first); });
  return entries;
}

void DescribeCorrection(const Graph& graph, Closure* closure) {
  const submap::Constraint& constraint = closure->constraint;
  const Rigid3d estimate = graph.submaps.at(constraint.submap_id).map_from_submap.inverse() *
                           graph.nodes.at(constraint.node_id).map_from_node;
  const Rigid3d correction = estimate.inverse() * constraint.submap_from_node;
  closure->correction_m = correction.translation().norm();
  closure->correction_deg = transform::RotationAngle(correction) * 180. / M_PI;
}

}  // namespace

ClosureSearch::ClosureSearch(const proto::PoseGraphOptions& options,
                             const scan_matching::ScoreModel& model, const sensor::LabelSet& labels)
    : options_(options),
      verify_in_plane_(options.verify_in() == "plane"),
      model_(model),
      labels_(labels),
      matchers_(model, static_cast<size_t>(options.scan_matching().cache_mib() * kBytesPerMiB)) {}

std::vector<SearchedCandidate> ClosureSearch::Search(
    const std::vector<ClosureCandidate>& candidates, const Graph& graph) {
  std::vector<SearchedCandidate> results;
  for (size_t begin = 0; begin < candidates.size(); begin += kCandidatesAtOnce) {
    const size_t end = std::min(candidates.size(), begin + kCandidatesAtOnce);
    SearchSome({candidates.begin() + begin, candidates.begin() + end}, graph, &results);
  }
  return results;
}

void ClosureSearch::SearchSome(const std::vector<ClosureCandidate>& candidates, const Graph& graph,
                               std::vector<SearchedCandidate>* results) {
  const Scans scans = MakeScans(candidates, graph);
  const Targets targets = verify_in_plane_ ? Targets() : MakeTargets(candidates, graph);
  const size_t first = results->size();
  results->resize(first + candidates.size());
  TrajectoryGroups groups(graph);
  std::vector<char> tied;
  for (const ClosureCandidate& candidate : candidates) {
    tied.push_back(groups.FirstOf(candidate.node_id.trajectory_id) ==
                   groups.FirstOf(candidate.submap_id.trajectory_id));
  }
  common::ParallelChunks(candidates.size(), 1, [&](size_t i, size_t) {
    const auto target = targets.find(candidates[i].submap_id);
    (*results)[first + i] =
        SearchOne(candidates[i], *scans.at(candidates[i].node_id),
                  target == targets.end() ? nullptr : target->second.get(), tied[i] != 0, graph);
  });
}

ClosureSearch::Scans ClosureSearch::MakeScans(const std::vector<ClosureCandidate>& candidates,
                                              const Graph& graph) const {
  Scans scans;
  for (const ClosureCandidate& candidate : candidates) scans[candidate.node_id] = nullptr;
  return MakeForEach<NodeId, MatchingScan>(std::move(scans), [&](const NodeId& node_id) {
    return std::make_shared<const MatchingScan>(
        Moved(*graph.nodes.at(node_id).cloud, LevelFromNode(graph.nodes.at(node_id))), model_);
  });
}

ClosureSearch::Targets ClosureSearch::MakeTargets(const std::vector<ClosureCandidate>& candidates,
                                                  const Graph& graph) const {
  Targets targets;
  for (const ClosureCandidate& candidate : candidates) targets[candidate.submap_id] = nullptr;
  return MakeForEach<SubmapId, ClosureTarget>(
      std::move(targets), [&](const SubmapId& id) { return MakeTarget(id, graph); });
}

std::shared_ptr<const ClosureTarget> ClosureSearch::MakeTarget(const SubmapId& submap_id,
                                                               const Graph& graph) const {
  const Rigid3d submap_from_map = graph.submaps.at(submap_id).map_from_submap.inverse();
  std::vector<ClosureTarget::Part> parts;
  const auto add = [&](int index) {
    const auto neighbour = graph.submaps.find({submap_id.trajectory_id, index});
    if (neighbour == graph.submaps.end() || !neighbour->second.submap->finished) return;
    parts.push_back(
        {&neighbour->second.submap->cloud, submap_from_map * neighbour->second.map_from_submap});
  };
  add(submap_id.submap_index);
  for (int step = 1; step <= options_.joined_neighbours(); ++step) {
    add(submap_id.submap_index - step);
    add(submap_id.submap_index + step);
  }
  return std::make_shared<const ClosureTarget>(parts, labels_, options_.verification());
}

SearchedCandidate ClosureSearch::SearchOne(const ClosureCandidate& candidate,
                                           const MatchingScan& scan, const ClosureTarget* target,
                                           bool tied, const Graph& graph) {
  SearchedCandidate result;
  Closure& closure = result.closure;
  closure.by_place_recognition = candidate.by_place_recognition;
  closure.constraint.kind = submap::Constraint::Kind::kInterSubmap;
  closure.constraint.submap_id = candidate.submap_id;
  closure.constraint.node_id = candidate.node_id;

  const auto matcher =
      matchers_.Get(candidate.submap_id, *graph.submaps.at(candidate.submap_id).submap);
  const std::optional<Match> match = matcher->MatchInWindow(scan, candidate.submap_from_node_guess,
                                                            candidate.window, options_.min_score());
  if (!match.has_value()) {
    result.verdict = "no_match";
    return result;
  }
  closure.score = match->score;

  const scan_matching::PlanarRefinement refined = scan_matching::RefineInPlane(
      *matcher, scan, match->submap_from_node, options_.scan_matching().refinement());

  if (verify_in_plane_) {
    VerifyInPlane(refined, graph, &closure);
    result.verdict = std::string(VerdictName(Verdict::kAccepted));
    return result;
  }
  const submap::PlacedNode& node = graph.nodes.at(candidate.node_id);
  const Rigid3d submap_from_level = scan_matching::InSpace(refined.submap_from_node);
  const Rigid3d level_from_node =
      tied ? LevelFromNode(node, graph.submaps.at(candidate.submap_id))
           : LevelFromVisitor(submap_from_level, candidate.submap_id, graph);
  const ClosureReport report = VerifyClosure(*node.cloud, submap_from_level * level_from_node,
                                             *target, options_.verification());
  result.verdict = std::string(VerdictName(report.verdict));
  closure.overlap = report.overlap;
  closure.inlier_ratio = report.inlier_ratio;
  closure.constraint.submap_from_node = report.submap_from_node;
  closure.constraint.information = report.information;
  DescribeCorrection(graph, &closure);
  VLOG(1) << "node " << candidate.node_id.node_index << " in submap "
          << candidate.submap_id.submap_index << ": " << result.verdict << ", score "
          << closure.score << ", overlap " << closure.overlap << ", inliers "
          << closure.inlier_ratio;
  return result;
}

void ClosureSearch::VerifyInPlane(const scan_matching::PlanarRefinement& refined,
                                  const Graph& graph, Closure* closure) const {
  submap::Constraint& constraint = closure->constraint;
  const submap::PlacedNode& node = graph.nodes.at(constraint.node_id);
  const Rigid3d& map_from_submap = graph.submaps.at(constraint.submap_id).map_from_submap;
  // Nothing was learned about the height: it is as the map has it.
  const double height_m = (map_from_submap.inverse() * node.map_from_node).translation().z();
  constraint.submap_from_node = Rigid3d::Translation({0., 0., height_m}) *
                                scan_matching::InSpace(refined.submap_from_node) *
                                LevelFromNode(node);
  const double sigma_m = options_.planar_closure().sigma_m();
  const double sigma_rad = options_.planar_closure().sigma_deg() * M_PI / 180.;
  transform::Twist sigmas;
  sigmas << sigma_m, sigma_m, kUnseenHeight_m, kUnseenTilt_rad, kUnseenTilt_rad, sigma_rad;
  constraint.information = sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
  closure->in_plane = true;
  closure->inlier_ratio = refined.agreement;
  closure->overlap = refined.agreement;
  DescribeCorrection(graph, closure);
}

std::optional<ClosureCandidate> ClosureSearch::FindBest(
    const std::vector<ClosureCandidate>& candidates, const SubmapId& own_submap_id,
    const Graph& graph) {
  if (candidates.empty()) return std::nullopt;
  const proto::CandidateOptions& options = options_.candidates();
  const submap::Submap& own = *graph.submaps.at(own_submap_id).submap;
  const submap::PlacedNode& node = graph.nodes.at(candidates.front().node_id);
  const Rigid3d level_from_own =
      transform::Level(node.local_from_node).inverse() * own.local_from_submap;
  const MatchingScan scan(Moved(own.cloud, level_from_own), model_,
                          options.search_all().max_points());
  std::optional<ClosureCandidate> best;
  double best_score = options.search_all().min_score();
  for (size_t begin = 0; begin < candidates.size(); begin += kCandidatesAtOnce) {
    const size_t size = std::min(candidates.size() - begin, kCandidatesAtOnce);
    std::vector<scan_matching::SearchArea> areas(size);
    common::ParallelChunks(size, 1, [&](size_t i, size_t) {
      const ClosureCandidate& candidate = candidates[begin + i];
      const SubmapId& id = candidate.submap_id;
      areas[i] = {matchers_.Get(id, *graph.submaps.at(id).submap),
                  {{candidate.submap_from_node_guess, candidate.window}}};
    });
    const auto found = scan_matching::MatchInAny(areas, scan, best_score);
    if (!found.has_value() || (best.has_value() && found->match.score <= best_score)) continue;
    best_score = found->match.score;
    best = candidates[begin + found->index];
    best->submap_from_node_guess = found->match.submap_from_node;
  }
  VLOG(1) << "best of " << candidates.size()
          << " submaps: " << (best.has_value() ? best_score : 0.);
  if (best.has_value()) {
    best->window = {options.place_linear_m(), options.place_angular_deg() * M_PI / 180.};
  }
  return best;
}

}  // namespace cartographer::pose_graph
