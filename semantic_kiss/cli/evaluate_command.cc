// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <iostream>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"
#include "cartographer/io/trajectory_files.h"
#include "gflags/gflags.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/evaluation_text.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/evaluation/evaluation.h"
#include "semantic_kiss/report/json_text.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::common::AddContext;
using cartographer::transform::Rigid3d;
using evaluation::GuessVehicleFrame;
using evaluation::VehicleFrame;
using Poses = std::vector<Rigid3d>;

// Brings lidar poses into the camera's frame. An estimate that plainly is the camera's already, as
// `run` writes it where there is a calibration, stays as it is.
absl::StatusOr<Poses> ReadEstimate() {
  ASSIGN_OR_RETURN(Poses estimate, cartographer::io::ReadKittiPoses(FLAGS_estimate));
  if (FLAGS_calib.empty()) return estimate;
  ASSIGN_OR_RETURN(const Rigid3d camera_from_lidar,
                   cartographer::io::ReadKittiCalibration(FLAGS_calib));
  if (GuessVehicleFrame(estimate) == VehicleFrame::kCamera) return estimate;
  return cartographer::io::PosesOfOtherBody(estimate, camera_from_lidar);
}

absl::StatusOr<Poses> ReadGroundTruth(int num_poses) {
  ASSIGN_OR_RETURN(const Poses truth, cartographer::io::ReadKittiPoses(FLAGS_ground_truth));
  if (gflags::GetCommandLineFlagInfoOrDie("first_scan").is_default) return truth;
  absl::StatusOr<Poses> part = evaluation::GroundTruthOfScans(truth, FLAGS_first_scan, num_poses);
  if (!part.ok()) return AddContext(part.status(), FLAGS_ground_truth);
  return part;
}

absl::Status RunEvaluate() {
  ASSIGN_OR_RETURN(const Poses estimate, ReadEstimate());
  ASSIGN_OR_RETURN(const Poses truth, ReadGroundTruth(static_cast<int>(estimate.size())));
  if (truth.size() != estimate.size()) {
    return absl::InvalidArgumentError(absl::StrFormat(
        "%s has %d poses, but %s has %d; if the estimate is of a part of the drive, "
        "say where it begins with --first_scan=N",
        FLAGS_estimate, estimate.size(), FLAGS_ground_truth, truth.size()));
  }
  RETURN_IF_ERROR(AddContext(evaluation::CheckSameBody(truth, estimate), FLAGS_estimate));
  const VehicleFrame frame = GuessVehicleFrame(truth).value_or(
      GuessVehicleFrame(estimate).value_or(VehicleFrame::kCamera));
  const absl::StatusOr<evaluation::Evaluation> result =
      evaluation::Evaluate(truth, estimate, frame);
  if (!result.ok()) return AddContext(result.status(), FLAGS_estimate);
  if (FLAGS_json) {
    std::cout << report::JsonText(evaluation::ToJson(evaluation::MetricsOf(*result)), 2)
              << std::endl;
  } else {
    std::cout << EvaluationText(*result, static_cast<int>(truth.size()));
  }
  return absl::OkStatus();
}

}  // namespace

Command EvaluateCommand() {
  Command command;
  command.name = "evaluate";
  command.summary = "compare a trajectory with ground truth";
  command.description =
      "Prints RTE as the KITTI odometry benchmark has it (segments of 100 to 800 m), the ATE in "
      "space and in the plane (RMSE of positions after the best rigid alignment, without scale), "
      "and how far the last pose is off. Figures that do not exist, such as the RTE of a drive "
      "under 100 m, are shown as \"-\", in JSON as null.\n\n"
      "Both files hold one pose a line in KITTI's format. Poses of the lidar are compared with "
      "those of KITTI's camera by giving the calibration; poses that are the camera's already are "
      "left as they are.";
  command.flags = {{"ground_truth", true}, {"estimate", true}, {"calib"}, {"first_scan"}, {"json"}};
  command.examples = {
      {"A whole sequence of KITTI",
       "evaluate --ground_truth=poses/00.txt --estimate=output/trajectory_kitti.txt"},
      {"100 scans from scan 500 on, as lidar poses",
       "evaluate --ground_truth=poses/00.txt --estimate=part.txt --calib=00/calib.txt "
       "--first_scan=500"}};
  command.run = &RunEvaluate;
  return command;
}

}  // namespace semantic_kiss::cli
