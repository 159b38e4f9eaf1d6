// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/map_builder.h"

#include <utility>

#include "glog/logging.h"

namespace cartographer::slam {
namespace {

// One drive, one trajectory.
constexpr int kTrajectoryId = 0;

}  // namespace

MapBuilder::MapBuilder(std::unique_ptr<LocalTrajectoryBuilder> local_trajectory_builder,
                       const sensor::LabelSet& labels)
    : local_trajectory_builder_(std::move(local_trajectory_builder)) {
  CHECK(local_trajectory_builder_ != nullptr);
  map_.labels = labels;
}

LocalResult MapBuilder::AddScan(const sensor::LabeledScan& scan) {
  CHECK(scan_poses_.empty() || scan.time > scan_poses_.back().time);
  LocalResult result = local_trajectory_builder_->AddScan(scan);
  if (result.insertion.has_value()) AddNode(result);
  CHECK_GT(num_nodes_, 0);
  const submap::NodeId node_id{kTrajectoryId, num_nodes_ - 1};
  scan_poses_.push_back(
      {scan.time, result.local_from_sensor, node_id,
       map_.nodes.at(node_id).local_from_node.inverse() * result.local_from_sensor});
  return result;
}

void MapBuilder::AddNode(const LocalResult& result) {
  const submap::NodeId node_id{kTrajectoryId, num_nodes_++};
  map_.nodes.emplace(node_id, map::MapNode{result.time, result.local_from_sensor,
                                           result.local_from_sensor, result.insertion->cloud});
  for (const auto& [index, submap] : result.insertion->submaps) {
    const submap::SubmapId submap_id{kTrajectoryId, index};
    map_.submaps.emplace(submap_id, map::MapSubmap{submap->local_from_submap, submap});
    map::Constraint constraint;
    constraint.submap_id = submap_id;
    constraint.node_id = node_id;
    constraint.submap_from_node = submap->local_from_submap.inverse() * result.local_from_sensor;
    constraint.kind = map::Constraint::Kind::kIntraSubmap;
    map_.constraints.push_back(constraint);
  }
}

map::Map MapBuilder::Finish() {
  local_trajectory_builder_->Finish();
  return std::move(map_);
}

std::vector<transform::Rigid3d> PlaceScans(const map::Map& map,
                                           const std::vector<ScanPose>& scan_poses) {
  std::vector<transform::Rigid3d> map_from_scan;
  map_from_scan.reserve(scan_poses.size());
  for (const ScanPose& scan : scan_poses) {
    map_from_scan.push_back(map.nodes.at(scan.node_id).map_from_node * scan.node_from_sensor);
  }
  return map_from_scan;
}

}  // namespace cartographer::slam
