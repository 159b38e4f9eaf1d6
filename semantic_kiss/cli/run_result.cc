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

// Only where there is ground truth.
absl::StatusOr<evaluation::Evaluation> EvaluateRun(const dataset::ScanSource& scans,
                                                   const Poses& trajectory) {
  const Poses truth(scans.ground_truth()->begin(),
                    scans.ground_truth()->begin() + trajectory.size());
  const auto& camera_from_sensor = scans.camera_from_sensor();
  return evaluation::Evaluate(AsInFiles(truth, camera_from_sensor), trajectory,
                              camera_from_sensor ? VehicleFrame::kCamera : VehicleFrame::kLidar);
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
  result.map.configuration_lua = configuration.lua;
  result.map.history.push_back(absl::StrCat("semantic_kiss ", Version()));

  Poses local_from_lidar;
  for (const cartographer::slam::ScanPose& scan : map_builder->scan_poses()) {
    result.times.push_back(scan.time);
    local_from_lidar.push_back(scan.local_from_sensor);
  }
  result.map_from_lidar = cartographer::slam::PlaceScans(result.map, map_builder->scan_poses());
  result.odometry = AsInFiles(local_from_lidar, scans.camera_from_sensor());
  result.trajectory = AsInFiles(result.map_from_lidar, scans.camera_from_sensor());
  result.closures =
      GatherClosures(*map_builder, result.map,
                     scans.ground_truth().has_value() ? &*scans.ground_truth() : nullptr);
  if (scans.ground_truth().has_value()) {
    ASSIGN_OR_RETURN(result.evaluation, EvaluateRun(scans, result.trajectory));
  }
  return result;
}

}  // namespace semantic_kiss::cli
