// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_RESULT_H_
#define SEMANTIC_KISS_CLI_RUN_RESULT_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/map/map.h"
#include "cartographer/slam/map_builder.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/drive.h"
#include "semantic_kiss/cli/run_closures.h"
#include "semantic_kiss/dataset/scan_source.h"
#include "semantic_kiss/evaluation/evaluation.h"

namespace semantic_kiss::cli {

// Everything that a run found out: what its files, its report and its summary are made from.
struct RunResult {
  DriveRecord drive;
  int scans_available = 0;
  std::vector<std::string> notes;
  dataset::UnknownLabelIds unknown_label_ids;

  std::vector<cartographer::common::Time> times;
  // Poses as files have them: of the camera if the data set has one, else of the lidar. As the
  // odometry saw the drive, and as the map has it.
  std::vector<cartographer::transform::Rigid3d> odometry, trajectory;
  // Poses of the lidar: as the odometry saw the drive, and in the map.
  std::vector<cartographer::transform::Rigid3d> local_from_lidar, map_from_lidar;
  // And in truth, in the world of the ground truth; empty if there is none.
  std::vector<cartographer::transform::Rigid3d> true_lidar_poses;
  cartographer::map::Map map;
  int trajectory_id = 0;  // of the drive in the map; others were there before
  RunClosures closures;
  // The odometry's drive, from the first scan's place in the map on: what maps are compared with,
  // also where an earlier map was continued and the two frames have nothing in common.
  std::vector<cartographer::transform::Rigid3d> OdometryInMap() const;

  // Where there is ground truth: of `trajectory`, and of `odometry`.
  std::optional<evaluation::Evaluation> evaluation, odometry_evaluation;
};

// Ends the drive and gathers what is to be told of it, at least one scan (CHECKed). Fails if the
// ground truth cannot be compared with the poses.
absl::StatusOr<RunResult> Conclude(const Configuration& configuration, DriveRecord drive,
                                   const dataset::ScanSource& scans,
                                   cartographer::slam::MapBuilder* map_builder);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_RESULT_H_
