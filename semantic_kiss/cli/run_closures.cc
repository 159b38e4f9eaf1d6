// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_closures.h"

#include <algorithm>
#include <map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::map::Constraint;
using cartographer::map::Map;
using cartographer::pose_graph::Closure;
using cartographer::pose_graph::NodeSearch;
using cartographer::slam::ScanPose;
using cartographer::submap::NodeId;
using cartographer::submap::SubmapId;
using cartographer::transform::Level;
using cartographer::transform::Rigid3d;
using evaluation::ClosureClaim;
using Json = nlohmann::ordered_json;

const char* FoundBy(const Closure& closure) {
  return closure.by_place_recognition ? "place_recognition" : "nearby";
}

std::map<NodeId, int> ScanOfNode(const std::vector<ScanPose>& scan_poses) {
  std::map<NodeId, int> scans;
  // The first scan of a node's is the node itself; emplace() keeps it.
  for (size_t i = 0; i < scan_poses.size(); ++i) {
    scans.emplace(scan_poses[i].node_id, static_cast<int>(i));
  }
  return scans;
}

// For each submap the constraint with its first node.
std::map<SubmapId, const Constraint*> AnchorsOf(const Map& map) {
  std::map<SubmapId, const Constraint*> anchors;
  for (const Constraint& constraint : map.constraints) {
    if (constraint.kind == Constraint::Kind::kIntraSubmap) {
      anchors.emplace(constraint.submap_id, &constraint);
    }
  }
  return anchors;
}

Rigid3d EarlierFromRevisit(const Constraint& anchor, const Closure& closure) {
  if (!closure.in_plane) {
    return anchor.submap_from_node.inverse() * closure.constraint.submap_from_node;
  }
  return Level(anchor.submap_from_node).inverse() * Level(closure.constraint.submap_from_node);
}

// Absent for closures with drives that were there before: the truth about them is not known.
std::vector<std::optional<ClosureClaim>> ClaimsOf(const std::vector<Closure>& closures,
                                                  const Map& map,
                                                  const std::vector<ScanPose>& scan_poses) {
  const std::map<NodeId, int> scan_of_node = ScanOfNode(scan_poses);
  const std::map<SubmapId, const Constraint*> anchors = AnchorsOf(map);
  std::vector<std::optional<ClosureClaim>> claims;
  for (const Closure& closure : closures) {
    const Constraint& anchor = *anchors.at(closure.constraint.submap_id);
    const auto earlier = scan_of_node.find(anchor.node_id);
    const auto revisit = scan_of_node.find(closure.constraint.node_id);
    claims.emplace_back();
    if (earlier == scan_of_node.end() || revisit == scan_of_node.end()) continue;
    claims.back() = {earlier->second, revisit->second, EarlierFromRevisit(anchor, closure),
                     closure.in_plane};
  }
  return claims;
}

// How far a candidate came decides what is known of it.
Json RejectedJson(const NodeId& node_id, const NodeSearch& search) {
  const Closure& closure = search.best_rejected->closure;
  const bool matched = search.best_rejected->verdict != "no_match";
  return {{"node", node_id.node_index},
          {"trajectory", node_id.trajectory_id},
          {"submap", closure.constraint.submap_id.submap_index},
          {"submap_trajectory", closure.constraint.submap_id.trajectory_id},
          {"by", FoundBy(closure)},
          {"verdict", search.best_rejected->verdict},
          {"score", matched ? Json(closure.score) : Json()},
          {"overlap", matched ? Json(closure.overlap) : Json()},
          {"inlier_ratio", matched ? Json(closure.inlier_ratio) : Json()},
          {"node_candidates", search.num_candidates},
          {"node_accepted", search.num_accepted}};
}

}  // namespace

int RunClosures::NumFalse() const {
  return static_cast<int>(std::count_if(errors.begin(), errors.end(), [](const auto& error) {
    return error.has_value() && error->False();
  }));
}

RunClosures GatherClosures(const cartographer::slam::MapBuilder& map_builder, const Map& map,
                           const std::vector<Rigid3d>* truth) {
  RunClosures result;
  result.closures = map_builder.closures();
  result.verdicts = map_builder.closure_verdicts();
  result.optimization = map_builder.last_optimization();
  for (const auto& [node_id, search] : map_builder.closure_searches()) {
    if (search.best_rejected.has_value()) result.rejected.emplace(node_id, search);
  }
  if (truth == nullptr) return result;
  const std::vector<ScanPose>& scan_poses = map_builder.scan_poses();
  const std::vector<Rigid3d> driven(truth->begin(), truth->begin() + scan_poses.size());
  std::vector<ClosureClaim> own_claims;
  for (const auto& claim : ClaimsOf(result.closures, map, scan_poses)) {
    result.errors.emplace_back();
    if (!claim.has_value()) continue;
    own_claims.push_back(*claim);
    result.errors.back() = evaluation::ClosureErrors({*claim}, driven).front();
  }
  result.coverage = evaluation::ComputeRevisitCoverage(own_claims, driven, {});
  return result;
}

Json ClosuresJson(const RunClosures& closures) {
  Json list = Json::array();
  for (size_t i = 0; i < closures.closures.size(); ++i) {
    const Closure& closure = closures.closures[i];
    const bool known = i < closures.errors.size() && closures.errors[i].has_value();
    list.push_back({{"node", closure.constraint.node_id.node_index},
                    {"trajectory", closure.constraint.node_id.trajectory_id},
                    {"submap", closure.constraint.submap_id.submap_index},
                    {"submap_trajectory", closure.constraint.submap_id.trajectory_id},
                    {"by", FoundBy(closure)},
                    {"score", closure.score},
                    {"overlap", closure.overlap},
                    {"inlier_ratio", closure.inlier_ratio},
                    {"correction_m", closure.correction_m},
                    {"correction_deg", closure.correction_deg},
                    {"true_error_m", known ? Json(closures.errors[i]->distance_m) : Json()},
                    {"true_error_deg", known ? Json(closures.errors[i]->angle_deg) : Json()}});
  }
  return list;
}

Json ClosureSearchJson(const RunClosures& closures) {
  Json json;
  json["candidates"] = closures.verdicts;
  json["false"] = closures.errors.empty() ? Json() : Json(closures.NumFalse());
  const bool known = closures.coverage.has_value();
  json["revisited_m"] = known ? Json(closures.coverage->revisited_m) : Json();
  const auto share = known ? closures.coverage->ClosedShare() : std::nullopt;
  json["closed_share"] = share.has_value() ? Json(*share) : Json();
  json["optimization"] = {{"solved", closures.optimization.usable},
                          {"converged", closures.optimization.converged},
                          {"loops", closures.optimization.num_loops},
                          {"loops_outweighed", closures.optimization.num_rejected}};
  json["rejected"] = Json::array();
  for (const auto& [node_id, search] : closures.rejected) {
    json["rejected"].push_back(RejectedJson(node_id, search));
  }
  return json;
}

std::string ClosuresLine(const RunClosures& closures) {
  int candidates = 0;
  for (const auto& [verdict, count] : closures.verdicts) candidates += count;
  std::string line =
      absl::StrCat(closures.closures.size(), " of ", candidates, " candidates accepted");
  if (!closures.errors.empty()) absl::StrAppend(&line, ", ", closures.NumFalse(), " false");
  const auto share =
      closures.coverage.has_value() ? closures.coverage->ClosedShare() : std::nullopt;
  if (share.has_value()) {
    absl::StrAppendFormat(&line, "; %.0f %% of %.0f m revisited are closed", 100. * *share,
                          closures.coverage->revisited_m);
  }
  const auto& optimization = closures.optimization;
  if (optimization.num_rejected > 0) {
    absl::StrAppend(&line, "; ", optimization.num_rejected, " outweighed by the others");
  }
  if (!optimization.usable) {
    absl::StrAppend(&line, "; the optimization failed, the map is as the odometry has it");
  } else if (!optimization.converged) {
    absl::StrAppend(&line, "; the optimization did not converge");
  }
  return line;
}

}  // namespace semantic_kiss::cli
