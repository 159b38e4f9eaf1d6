// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/map_view.h"

#include <map>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "semantic_kiss/report/along_path.h"

namespace semantic_kiss::report {
namespace {

using cartographer::map::Constraint;
using cartographer::map::Map;
using cartographer::transform::Rigid3d;

struct Drive {
  std::vector<cartographer::common::Time> times;
  std::vector<Rigid3d> poses;
};

std::map<int, Drive> DrivesOf(const Map& map) {
  std::map<int, Drive> drives;
  for (const auto& [id, node] : map.nodes) {
    if (!node.map_from_node.translation().allFinite()) continue;
    drives[id.trajectory_id].times.push_back(node.time);
    drives[id.trajectory_id].poses.push_back(node.map_from_node);
  }
  return drives;
}

void AddClosures(const Map& map, MapView* view) {
  view->closure_facts = {"node", "submap"};
  for (const Constraint& constraint : map.constraints) {
    if (constraint.kind != Constraint::Kind::kInterSubmap) continue;
    const auto node = map.nodes.find(constraint.node_id);
    const auto submap = map.submaps.find(constraint.submap_id);
    if (node == map.nodes.end() || submap == map.submaps.end()) continue;
    ClosureMark mark;
    mark.node = node->second.map_from_node.translation().head<2>();
    mark.submap = submap->second.map_from_submap.translation().head<2>();
    mark.facts = {absl::StrCat(constraint.node_id.node_index),
                  absl::StrCat(constraint.submap_id.submap_index)};
    view->closures.push_back(std::move(mark));
  }
}

}  // namespace

MapView ViewOf(const Map& map, MapLayers layers, const std::string& caption) {
  MapView view;
  view.caption = caption;
  view.layers = std::move(layers);
  for (const auto& [id, drive] : DrivesOf(map)) {
    if (view.paths.empty()) {
      view.colorings = {{"speed", "m/s", Speeds(drive.times, drive.poses)},
                        {"height", "m", Heights(drive.poses)}};
    }
    view.paths.push_back(
        {absl::StrCat("trajectory ", id), Role::kTrajectory, PlanePositions(drive.poses)});
  }
  AddClosures(map, &view);
  return view;
}

}  // namespace semantic_kiss::report
