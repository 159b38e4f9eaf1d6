// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_result.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/io/trajectory_files.h"
#include "glog/logging.h"
#include "semantic_kiss/cli/version.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::transform::Rigid3d;
using evaluation::VehicleFrame;
using Poses = std::vector<Rigid3d>;

Poses AsInFiles(const Poses& lidar_poses, const std::optional<Rigid3d>& camera_from_sensor) {
  if (!camera_from_sensor.has_value()) return lidar_poses;
  return cartographer::io::PosesOfOtherBody(lidar_poses, *camera_from_sensor);
}

// Only where there is ground truth. A drive that went wrong is compared like any other: its map and
// report are what tells why.
absl::Status Compare(const dataset::ScanSource& scans, RunResult* result) {
  result->true_lidar_poses.assign(scans.ground_truth()->begin(),
                                  scans.ground_truth()->begin() + result->trajectory.size());
  const auto& camera_from_sensor = scans.camera_from_sensor();
  const Poses truth = AsInFiles(result->true_lidar_poses, camera_from_sensor);
  const auto frame = camera_from_sensor ? VehicleFrame::kCamera : VehicleFrame::kLidar;
  ASSIGN_OR_RETURN(const auto odometry, evaluation::Evaluate(truth, result->odometry, frame));
  ASSIGN_OR_RETURN(result->evaluation, evaluation::Evaluate(truth, result->trajectory, frame));
  result->odometry_evaluation = odometry;
  if (!evaluation::CheckSameBody(truth, result->odometry).ok()) {
    result->notes.push_back(absl::StrCat(
        "the drive goes along another axis than the ground truth: the odometry is lost, or the "
        "ground truth is not of the ",
        evaluation::NameOf(frame)));
  }
  return absl::OkStatus();
}

// The last loop closures are part of the drive's time.
void FinishMap(cartographer::slam::MapBuilder* map_builder, RunResult* result) {
  cartographer::common::Stopwatch stopwatch;
  std::vector<cartographer::common::StageTime> stage_times;
  result->map = map_builder->Finish(&stage_times);
  for (const auto& time : stage_times) result->drive.stage_times.Add(time.stage, time.seconds);
  result->drive.elapsed_s += stopwatch.Lap();
}

}  // namespace

Poses RunResult::OdometryInMap() const {
  if (local_from_lidar.empty()) return {};
  const Rigid3d map_from_local = map_from_lidar.front() * local_from_lidar.front().inverse();
  Poses poses;
  for (const Rigid3d& pose : local_from_lidar) poses.push_back(map_from_local * pose);
  return poses;
}

absl::StatusOr<RunResult> Conclude(const Configuration& configuration, DriveRecord drive,
                                   const dataset::ScanSource& scans,
                                   cartographer::slam::MapBuilder* map_builder) {
  CHECK_GT(drive.num_scans, 0);
  RunResult result;
  result.drive = std::move(drive);
  result.scans_available = scans.size();
  result.notes = scans.notes();
  result.unknown_label_ids = scans.unknown_label_ids();

  FinishMap(map_builder, &result);
  result.trajectory_id = map_builder->trajectory_id();
  result.map.configuration_lua = configuration.lua;
  result.map.history.push_back(absl::StrCat("semantic_kiss ", Version()));

  for (const cartographer::slam::ScanPose& scan : map_builder->scan_poses()) {
    result.times.push_back(scan.time);
    result.local_from_lidar.push_back(scan.local_from_sensor);
  }
  for (TracedScan& traced : result.drive.traces) CompleteTrace(*map_builder, result.map, &traced);
  result.map_from_lidar = cartographer::slam::PlaceScans(result.map, map_builder->scan_poses());
  result.odometry = AsInFiles(result.local_from_lidar, scans.camera_from_sensor());
  result.trajectory = AsInFiles(result.map_from_lidar, scans.camera_from_sensor());
  result.closures =
      GatherClosures(*map_builder, result.map,
                     scans.ground_truth().has_value() ? &*scans.ground_truth() : nullptr);
  if (scans.ground_truth().has_value()) {
    const absl::Status compared = Compare(scans, &result);
    if (!compared.ok()) {
      result.notes.push_back(
          absl::StrCat("not compared with the ground truth: ", compared.message()));
    }
  }
  return result;
}

}  // namespace semantic_kiss::cli
