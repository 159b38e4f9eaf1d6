// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/map_builder.h"

#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/slam/graph_of_map.h"
#include "glog/logging.h"

namespace cartographer::slam {

MapBuilder::MapBuilder(std::unique_ptr<LocalTrajectoryBuilder> local_trajectory_builder,
                       std::unique_ptr<pose_graph::PoseGraph> pose_graph,
                       const sensor::LabelSet& labels, int trajectory_id)
    : local_trajectory_builder_(std::move(local_trajectory_builder)),
      pose_graph_(std::move(pose_graph)),
      labels_(labels),
      trajectory_id_(trajectory_id) {
  CHECK(local_trajectory_builder_ != nullptr);
  CHECK(pose_graph_ != nullptr);
}

LocalResult MapBuilder::AddScan(const sensor::LabeledScan& scan) {
  CHECK(scan_poses_.empty() || scan.time > scan_poses_.back().time);
  LocalResult result = local_trajectory_builder_->AddScan(scan);
  if (result.insertion.has_value()) AddNode(&result);
  CHECK_GT(num_nodes_, 0);
  const submap::NodeId node_id{trajectory_id_, num_nodes_ - 1};
  const submap::PlacedNode& node = pose_graph_->graph().nodes.at(node_id);
  scan_poses_.push_back({scan.time, result.local_from_sensor, node_id,
                         node.local_from_node.inverse() * result.local_from_sensor});
  return result;
}

void MapBuilder::AddNode(LocalResult* result) {
  const submap::NodeId node_id{trajectory_id_, num_nodes_++};
  std::vector<common::StageTime> graph_times;
  pose_graph_->AddNode(node_id,
                       {result->time, {}, result->local_from_sensor, result->insertion->cloud},
                       result->insertion->submaps, &graph_times);
  if (trace_ != nullptr) TraceNode(node_id, graph_times);
  result->stage_times.insert(result->stage_times.end(), graph_times.begin(), graph_times.end());
}

void MapBuilder::TraceTo(ScanTrace* trace) {
  trace_ = trace;
  local_trajectory_builder_->TraceTo(trace);
}

void MapBuilder::TraceNode(const submap::NodeId& node_id,
                           const std::vector<common::StageTime>& graph_times) const {
  const pose_graph::Graph& graph = pose_graph_->graph();
  std::string text = PoseText(graph.nodes.at(node_id).map_from_node);
  double seconds = 0.;
  for (const common::StageTime& time : graph_times) seconds += time.seconds;
  if (!graph_times.empty()) {
    absl::StrAppend(&text, "; a round of the search for closures fell due, over ",
                    pose_graph_->last_outcomes().size(), " nodes");
  }
  TraceStep step{"pose graph", "map",
                 absl::StrCat("node ", node_id.node_index, " of trajectory ", node_id.trajectory_id,
                              " at ", text)};
  trace_->push_back(step.Took(seconds));
}

map::Map MapBuilder::Finish(std::vector<common::StageTime>* stage_times) {
  local_trajectory_builder_->Finish();
  pose_graph_->Finish(stage_times);
  tied_ = pose_graph_->IsTied(trajectory_id_);
  return MapOf(pose_graph_->Release(), labels_);
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
