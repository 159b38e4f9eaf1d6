// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_report_map.h"

#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "semantic_kiss/cli/run_text.h"
#include "semantic_kiss/report/along_path.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::pose_graph::Closure;
using report::MapView;
using report::Role;

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

std::vector<std::string> FactsOf(const Closure& closure) {
  return {absl::StrCat(closure.constraint.node_id.node_index),
          absl::StrCat(closure.constraint.submap_id.submap_index),
          closure.by_place_recognition ? "place recognition" : "nearby",
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

void AddClosures(const RunResult& result, MapView* view) {
  const RunClosures& closures = result.closures;
  view->closure_facts = {"node", "submap", "found by", "score", "overlap", "inliers", "correction"};
  if (!closures.errors.empty()) view->closure_facts.push_back("true error");
  for (size_t i = 0; i < closures.closures.size(); ++i) {
    const auto& constraint = closures.closures[i].constraint;
    const auto node = result.map.nodes.find(constraint.node_id);
    const auto submap = result.map.submaps.find(constraint.submap_id);
    if (node == result.map.nodes.end() || submap == result.map.submaps.end()) continue;
    report::ClosureMark mark;
    mark.node = node->second.map_from_node.translation().head<2>();
    mark.submap = submap->second.map_from_submap.translation().head<2>();
    mark.facts = FactsOf(closures.closures[i]);
    if (!closures.errors.empty()) {
      const std::optional<evaluation::ClosureError>& error = closures.errors[i];
      if (error.has_value()) mark.right = !error->False();
      mark.facts.push_back(ErrorText(error));
    }
    view->closures.push_back(std::move(mark));
  }
}

}  // namespace

MapView RunMapView(const RunResult& result, report::MapLayers layers) {
  MapView view;
  view.caption = "of the run";
  view.layers = std::move(layers);
  AddPaths(result, &view);
  AddColorings(result, &view);
  AddClosures(result, &view);
  return view;
}

}  // namespace semantic_kiss::cli
