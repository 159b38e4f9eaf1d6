// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/relocalizer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cartographer/slam/graph_of_map.h"
#include "glog/logging.h"

namespace cartographer::slam {
namespace {

using submap::NodeId;
using transform::Rigid3d;

// Trimming walks through all of the map, so it waits until there is something to gain.
constexpr double kTrimEvery_m = 10.;

}  // namespace

absl::string_view StateName(LocalizationState state) {
  switch (state) {
    case LocalizationState::kSearching:
      return "searching";
    case LocalizationState::kLocalized:
      return "localized";
    case LocalizationState::kLost:
      return "lost";
  }
  LOG(FATAL) << "no such state: " << static_cast<int>(state);
}

Relocalizer::Relocalizer(const proto::RelocalizationOptions& options, MakeBuilder make_builder,
                         std::unique_ptr<pose_graph::PoseGraph> pose_graph, const map::Map& map)
    : options_(options),
      make_builder_(std::move(make_builder)),
      pose_graph_(std::move(pose_graph)) {
  CHECK(pose_graph_ != nullptr);
  pose_graph_->AddMap(FrozenGraphOf(map));
  trajectory_id_ = NextTrajectoryId(map);
  BeginTrajectory();
}

void Relocalizer::BeginTrajectory() {
  builder_ = make_builder_();
  CHECK(builder_ != nullptr);
  num_nodes_ = 0;
  failures_ = 0;
  driven_m_ = 0.;
  matched_at_m_ = 0.;
  last_match_.reset();
  local_from_last_.reset();
  kept_.clear();
}

void Relocalizer::StartNear(const Eigen::Vector2d& position, double yaw) {
  CHECK(smoothed_.empty());
  // The map tells how high the sensor is there.
  double height_m = 0., nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [id, node] : pose_graph_->graph().nodes) {
    const Eigen::Vector3d& at = node.map_from_node.translation();
    const double distance_m = (at.head<2>() - position).norm();
    if (distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    height_m = at.z();
  }
  const Eigen::Vector3d start(position.x(), position.y(), height_m);
  pose_graph_->ExpectNear(
      trajectory_id_,
      Rigid3d(start, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()))),
      options_.initial_pose_path_m());
}

LocalizedScan Relocalizer::AddScan(const sensor::LabeledScan& scan) {
  LocalResult result = builder_->AddScan(scan);
  if (local_from_last_.has_value()) {
    driven_m_ += (result.local_from_sensor.translation() - local_from_last_->translation()).norm();
  }
  local_from_last_ = result.local_from_sensor;
  const Rigid3d local_from_sensor = result.local_from_sensor;
  const bool is_node = result.insertion.has_value();
  if (is_node) AddNode(&result);

  CHECK_GT(num_nodes_, 0);
  const NodeId node_id{trajectory_id_, num_nodes_ - 1};
  const submap::PlacedNode& node = pose_graph_->graph().nodes.at(node_id);
  pending_.push_back(
      {smoothed_.size(), node_id, node.local_from_node.inverse() * local_from_sensor});
  smoothed_.push_back(std::nullopt);
  if (is_node) Judge();

  LocalizedScan localized;
  localized.time = result.time;
  localized.state = state_;
  localized.reason = reason_;
  if (state_ == LocalizationState::kLocalized) {
    localized.map_from_sensor = pose_graph_->map_from_local() * local_from_sensor;
    localized.score = score_;
    localized.since_match_m = driven_m_ - matched_at_m_;
  }
  localized.outcome = std::move(result.outcome);
  localized.stage_times = std::move(result.stage_times);
  return localized;
}

void Relocalizer::AddNode(LocalResult* result) {
  const NodeId node_id{trajectory_id_, num_nodes_++};
  kept_.emplace_back(node_id, driven_m_);
  pose_graph_->AddNode(node_id,
                       {result->time, {}, result->local_from_sensor, result->insertion->cloud},
                       result->insertion->submaps, &result->stage_times);
}

void Relocalizer::Judge() {
  if (pose_graph_->last_outcomes().empty()) return;
  const bool was_localized = state_ == LocalizationState::kLocalized;
  for (const pose_graph::NodeOutcome& outcome : pose_graph_->last_outcomes()) {
    const bool found = outcome.verdict == "accepted";
    // Only what looked where it had to says anything: through all of the map, or near the estimate.
    if (!found && outcome.by_place == was_localized) continue;
    if (!was_localized) state_ = LocalizationState::kSearching;
    failures_ = found ? 0 : failures_ + 1;
    reason_ = found ? "no_agreement" : outcome.verdict;
  }
  NoteMatch();
  if (was_localized) {
    if (failures_ >= options_.lost_after_nodes()) return Lose(reason_);
  } else if (pose_graph_->IsTied(trajectory_id_)) {
    state_ = LocalizationState::kLocalized;
    failures_ = 0;
  }
  if (state_ == LocalizationState::kLocalized) reason_.clear();
  Trim();
}

void Relocalizer::NoteMatch() {
  if (pose_graph_->closures().empty()) return;
  const pose_graph::Closure& last = pose_graph_->closures().back();
  if (last_match_.has_value() && last.constraint.node_id == *last_match_) return;
  last_match_ = last.constraint.node_id;
  score_ = last.inlier_ratio;
  matched_at_m_ = driven_m_;
}

void Relocalizer::Lose(const std::string& reason) {
  // What came after the last match is what is not to be trusted.
  const int last_index = last_match_.has_value() ? last_match_->node_index : -1;
  Settle({trajectory_id_, last_index + 1});
  pending_.clear();
  pose_graph_->RemoveTrajectory(trajectory_id_);
  ++trajectory_id_;
  BeginTrajectory();
  state_ = LocalizationState::kLost;
  reason_ = reason;
}

void Relocalizer::Settle(const NodeId& first_kept) {
  const bool tied = pose_graph_->IsTied(trajectory_id_);
  while (!pending_.empty() && pending_.front().node_id < first_kept) {
    const Pending& scan = pending_.front();
    if (tied) {
      smoothed_[scan.scan] =
          pose_graph_->graph().nodes.at(scan.node_id).map_from_node * scan.node_from_sensor;
    }
    pending_.pop_front();
  }
}

void Relocalizer::Trim() {
  if (kept_.empty() || driven_m_ - kept_.front().second < options_.keep_m() + kTrimEvery_m) return;
  while (kept_.size() > 1 && driven_m_ - kept_.front().second > options_.keep_m()) {
    kept_.pop_front();
  }
  Settle(kept_.front().first);
  pose_graph_->TrimBefore(kept_.front().first);
}

std::vector<std::optional<Rigid3d>> Relocalizer::Finish() {
  builder_->Finish();
  const int last_index = last_match_.has_value() ? last_match_->node_index : -1;
  const bool localized = state_ == LocalizationState::kLocalized;
  Settle({trajectory_id_, localized ? num_nodes_ : last_index + 1});
  pending_.clear();
  return std::move(smoothed_);
}

}  // namespace cartographer::slam
