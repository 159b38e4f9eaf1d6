// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <iostream>
#include <memory>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/drive_flags.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/dataset/sequence_directory.h"
#include "semantic_kiss/simulation/preview.h"
#include "semantic_kiss/simulation/scan_preview.h"
#include "semantic_kiss/simulation/simulation.h"

namespace semantic_kiss::cli {
namespace {

using simulation::Simulation;
using simulation::proto::SimulationOptions;

void ApplyRouteFlags(simulation::proto::RouteOptions* route) {
  if (IsGiven("route")) route->set_kind(FLAGS_route);
  if (IsGiven("length")) route->set_length_m(FLAGS_length);
  if (IsGiven("lane_offset")) route->set_lane_offset_m(FLAGS_lane_offset);
  if (IsGiven("speed_factor")) route->set_speed_factor(FLAGS_speed_factor);
  if (!FLAGS_poses.empty()) {
    route->set_kind("recorded");
    route->set_poses_file(FLAGS_poses);
  }
}

// The configuration, overruled by the flags that are given.
absl::StatusOr<SimulationOptions> LoadSimulationOptions() {
  const std::string file = IsGiven("config") ? FLAGS_config : "simulation.lua";
  const std::string installed = InstalledConfigurationDirectory();
  ASSIGN_OR_RETURN(const std::string path,
                   cartographer::common::FindLuaFile(file, {"", installed}));
  SimulationOptions options;
  RETURN_IF_ERROR(cartographer::common::LoadOptions({path, {installed}}, &options));
  ApplyRouteFlags(options.mutable_route());
  if (IsGiven("seed")) options.set_seed(FLAGS_seed);
  if (IsGiven("epoch")) options.set_epoch(FLAGS_epoch);
  if (IsGiven("lidar")) options.set_lidar(FLAGS_lidar);
  if (IsGiven("label_noise")) options.mutable_label_noise()->set_share(FLAGS_label_noise);
  if (IsGiven("raw")) options.set_raw(FLAGS_raw);
  // What flags set must keep to the options' bounds as well.
  RETURN_IF_ERROR(cartographer::common::CheckOptions(options, "flags"));
  return options;
}

absl::Status Preview(const Simulation& drive) {
  const std::string installed = InstalledConfigurationDirectory();
  ASSIGN_OR_RETURN(const auto labels, cartographer::sensor::LabelSet::Load(
                                          {installed + "/labels/semantic_kitti.lua", {installed}}));
  if (!IsGiven("preview_scan")) return simulation::DrawPreview(drive, labels, FLAGS_preview);
  if (FLAGS_preview_scan < 0 || FLAGS_preview_scan >= drive.num_scans()) {
    return absl::InvalidArgumentError(absl::StrCat("--preview_scan=", FLAGS_preview_scan,
                                                   ": the drive has the scans 0 to ",
                                                   drive.num_scans() - 1));
  }
  return simulation::DrawScanPreview(drive, FLAGS_preview_scan, labels, FLAGS_preview);
}

absl::Status WriteScans(const Simulation& drive) {
  simulation::WriteRequest request;
  request.directory = FLAGS_output;
  request.sequence = FLAGS_sequence;
  request.num_scans = FLAGS_num_scans;
  ProgressReporter progress = MakeProgressReporter(simulation::ScansToWrite(drive, request));
  StopInGoodOrder();
  RETURN_IF_ERROR(simulation::WriteSequence(drive, request, [&](int done) {
    progress.Update(done, std::nullopt);
    return !StopRequested();
  }));
  progress.Finish();
  return absl::OkStatus();
}

absl::Status RunSimulate() {
  if (FLAGS_output.empty() && FLAGS_preview.empty()) {
    return absl::InvalidArgumentError("nothing to do: give --output=DIR, --preview=FILE or both");
  }
  RETURN_IF_ERROR(dataset::SequenceDirectory(FLAGS_output, FLAGS_sequence).status());
  ASSIGN_OR_RETURN(const SimulationOptions options, LoadSimulationOptions());
  ASSIGN_OR_RETURN(const std::unique_ptr<Simulation> drive, Simulation::Create(options));
  // The picture may be meant to lie beside the scans; what is wrong with the folder they will tell.
  std::error_code ignored;
  if (!FLAGS_output.empty()) std::filesystem::create_directories(FLAGS_output, ignored);
  if (!FLAGS_preview.empty()) RETURN_IF_ERROR(Preview(*drive));
  if (!FLAGS_output.empty()) RETURN_IF_ERROR(WriteScans(*drive));
  if (!FLAGS_quiet) {
    std::cout << absl::StreamFormat("%.0f m, %d scans, seed %d, day %d\n", drive->length_m(),
                                    drive->num_scans(), options.seed(), options.epoch());
    if (!FLAGS_output.empty()) {
      std::cout << absl::StreamFormat("scans: %s/sequences/%s\n", FLAGS_output, FLAGS_sequence);
    }
    if (!FLAGS_preview.empty()) std::cout << "picture: " << FLAGS_preview << "\n";
  }
  return absl::OkStatus();
}

}  // namespace

Command SimulateCommand() {
  Command command;
  command.name = "simulate";
  command.summary = "make a labeled drive through a simulated town";
  command.description =
      "Drives a lidar through a town that does not exist and writes its scans, labels and true "
      "poses as a sequence in SemanticKITTI's format, for `run` and everything else that reads "
      "it. The town is a function of --seed and the route; --epoch=1, 2, ... are other days, on "
      "which most parked vehicles differ and nothing else. --lane_offset and --speed_factor have "
      "another driver take the same way; poses are in the frame of the first. Files do not depend "
      "on --threads.\n\n"
      "--poses drives the way of a ground-truth file instead of a synthetic route; heights follow "
      "the file smoothly, so that every visit of a place finds the same ground. The poses written "
      "are the true ones.\n\n"
      "Points are deskewed and carry KITTI's vertical error of 0.205 degrees, as KITTI's do; "
      "--raw leaves them as measured and adds their times. Scans that are there already are kept, "
      "so an interrupted run may be repeated. docs/simulation.md explains the model.";
  command.flags = {{"config", false, "simulation.lua"},
                   {"route"},
                   {"poses"},
                   {"length"},
                   {"seed"},
                   {"epoch"},
                   {"lane_offset"},
                   {"speed_factor"},
                   {"lidar"},
                   {"num_scans"},
                   {"sequence"},
                   {"output"},
                   {"label_noise"},
                   {"raw"},
                   {"preview"},
                   {"preview_scan"},
                   {"threads"},
                   {"quiet"}};
  command.files = {
      {"sequences/NN/velodyne/*.bin", "Points: x, y, z, remission; float32."},
      {"sequences/NN/labels/*.label", "Label and, for what can be counted, instance; uint32."},
      {"sequences/NN/confidences/*.conf", "With --label_noise: certainty of each label; float32."},
      {"sequences/NN/point_times/*.bin",
       "With --raw: seconds relative to the end of the sweep; float32."},
      {"sequences/NN/poses.txt", "True poses in the camera's frame."},
      {"sequences/NN/{calib,times}.txt", "As KITTI has them."},
      {"sequences/NN/simulation.lua", "What the scans were made with."}};
  command.examples = {
      {"A drive of 800 m with revisits, and a picture of the town",
       "simulate --route=city --output=drive --preview=drive/town.png"},
      {"The way of a KITTI sequence, on another day, with a network's mistakes",
       "simulate --poses=poses/05.txt --epoch=1 --label_noise=0.05 --output=drive --sequence=05"}};
  command.run = &RunSimulate;
  return command;
}

}  // namespace semantic_kiss::cli
