// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_report_map.h"

#include <map>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "semantic_kiss/cli/closure_verdict.h"
#include "semantic_kiss/cli/run_text.h"
#include "semantic_kiss/report/along_path.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::pose_graph::Closure;
using cartographer::pose_graph::NodeSearch;
using report::MapView;
using report::Role;

void AddEarlierDrives(const RunResult& result, MapView* view) {
  std::map<int, std::vector<Eigen::Vector2d>> positions;
  for (const auto& [id, node] : result.map.nodes) {
    if (id.trajectory_id == result.trajectory_id) continue;
    positions[id.trajectory_id].push_back(node.map_from_node.translation().head<2>());
  }
  for (auto& [trajectory_id, path] : positions) {
    view->paths.push_back(
        {absl::StrCat("drive ", trajectory_id), Role::kEarlierDrive, std::move(path)});
  }
}

void AddPaths(const RunResult& result, MapView* view) {
  view->paths.push_back(
      {"trajectory", Role::kTrajectory, report::PlanePositions(result.map_from_lidar)});
  if (!result.closures.closures.empty()) {
    view->paths.push_back(
        {"odometry", Role::kOdometry, report::PlanePositions(result.OdometryInMap())});
  }
  if (!result.true_lidar_poses.empty()) {
    const auto truth = report::AlignedOnto(result.map_from_lidar, result.true_lidar_poses);
    view->paths.push_back({"ground truth", Role::kGroundTruth, report::PlanePositions(truth)});
  }
}

void AddColorings(const RunResult& result, MapView* view) {
  if (result.evaluation.has_value() && result.evaluation->absolute_3d.has_value()) {
    view->colorings.push_back({"error", "m", result.evaluation->absolute_3d->errors_m});
  }
  view->colorings.push_back({"speed", "m/s", report::Speeds(result.times, result.map_from_lidar)});
  view->colorings.push_back({"height", "m", report::Heights(result.map_from_lidar)});
  if (!result.closures.closures.empty()) {
    view->colorings.push_back(
        {"correction", "m", report::Distances(result.map_from_lidar, result.OdometryInMap())});
  }
}

std::string FoundBy(const Closure& closure) {
  return closure.by_place_recognition ? "place recognition" : "nearby";
}

std::vector<std::string> FactsOf(const Closure& closure) {
  return {absl::StrCat(closure.constraint.node_id.node_index),
          absl::StrCat(closure.constraint.submap_id.submap_index),
          FoundBy(closure),
          FigureText(closure.score, 2, ""),
          FigureText(closure.overlap, 2, ""),
          FigureText(closure.inlier_ratio, 2, ""),
          absl::StrFormat("%.2f m, %.2f°", closure.correction_m, closure.correction_deg)};
}

// Closures with what an earlier drive mapped have no known error.
std::string ErrorText(const std::optional<evaluation::ClosureError>& error) {
  if (!error.has_value()) return "-";
  return absl::StrFormat("%.2f m, %.2f°", error->distance_m, error->angle_deg);
}

// Where it is; nullopt if the map has not both ends.
std::optional<report::ClosureMark> MarkOf(const Closure& closure,
                                          const cartographer::map::Map& map) {
  const auto node = map.nodes.find(closure.constraint.node_id);
  const auto submap = map.submaps.find(closure.constraint.submap_id);
  if (node == map.nodes.end() || submap == map.submaps.end()) return std::nullopt;
  report::ClosureMark mark;
  mark.node = node->second.map_from_node.translation().head<2>();
  mark.submap = submap->second.map_from_submap.translation().head<2>();
  return mark;
}

std::vector<std::string> FactsOf(const NodeSearch& search) {
  const auto& [verdict, closure] = *search.best_rejected;
  const bool matched = verdict != "no_match";
  const auto figure = [&](double value) {
    return matched ? FigureText(value, 2, "") : std::string("-");
  };
  return {absl::StrCat(closure.constraint.node_id.node_index),
          absl::StrCat(closure.constraint.submap_id.submap_index),
          FoundBy(closure),
          verdict,
          MeaningOf(verdict),
          figure(closure.score),
          figure(closure.overlap),
          figure(closure.inlier_ratio),
          absl::StrCat(search.num_accepted, " of ", search.num_candidates)};
}

void AddRejected(const RunResult& result, MapView* view) {
  view->rejected_facts = {"node",  "submap",  "found by", "verdict", "why",
                          "score", "overlap", "inliers",  "accepted"};
  for (const auto& [node_id, search] : result.closures.rejected) {
    std::optional<report::ClosureMark> mark = MarkOf(search.best_rejected->closure, result.map);
    if (!mark.has_value()) continue;
    mark->facts = FactsOf(search);
    view->rejected.push_back(*std::move(mark));
  }
}

void AddClosures(const RunResult& result, MapView* view) {
  const RunClosures& closures = result.closures;
  view->closure_facts = {"node", "submap", "found by", "score", "overlap", "inliers", "correction"};
  if (!closures.errors.empty()) view->closure_facts.push_back("true error");
  for (size_t i = 0; i < closures.closures.size(); ++i) {
    std::optional<report::ClosureMark> placed = MarkOf(closures.closures[i], result.map);
    if (!placed.has_value()) continue;
    report::ClosureMark& mark = *placed;
    mark.facts = FactsOf(closures.closures[i]);
    if (!closures.errors.empty()) {
      const std::optional<evaluation::ClosureError>& error = closures.errors[i];
      if (error.has_value()) mark.right = !error->False();
      mark.facts.push_back(ErrorText(error));
    }
    view->closures.push_back(std::move(*placed));
  }
}

}  // namespace

MapView RunMapView(const RunResult& result, report::MapLayers layers) {
  MapView view;
  view.caption = "of the run";
  view.layers = std::move(layers);
  AddPaths(result, &view);
  AddEarlierDrives(result, &view);
  AddColorings(result, &view);
  AddClosures(result, &view);
  AddRejected(result, &view);
  return view;
}

}  // namespace semantic_kiss::cli
