// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_files.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/map_image.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/cli/run_json.h"
#include "semantic_kiss/cli/run_report.h"

namespace semantic_kiss::cli {
namespace {

namespace io = cartographer::io;

absl::Status WriteTrajectories(const OutputDirectory& directory, const RunResult& result) {
  RETURN_IF_ERROR(io::WriteKittiPoses(directory.FileNamed("odometry_kitti.txt"), result.odometry));
  RETURN_IF_ERROR(
      io::WriteKittiPoses(directory.FileNamed("trajectory_kitti.txt"), result.trajectory));
  return io::WriteTumPoses(directory.FileNamed("trajectory_tum.txt"), result.times,
                           result.map_from_lidar);
}

}  // namespace

absl::Status WriteRunFiles(const OutputDirectory& directory,
                           const io::proto::RenderOptions& map_image, RunResult* result) {
  StageTimes& times = result->drive.stage_times;
  cartographer::common::Stopwatch stopwatch;
  // First, because a drive without anything to draw is to leave no files at all.
  ASSIGN_OR_RETURN(const std::string image, io::RenderMapImage(result->map, map_image));
  times.Add("map_image", stopwatch.Lap());
  RETURN_IF_ERROR(io::WriteMap(result->map, directory.FileNamed("map.pbstream")));
  times.Add("map_file", stopwatch.Lap());
  RETURN_IF_ERROR(WriteTrajectories(directory, *result));
  RETURN_IF_ERROR(io::WriteFileAtomically(directory.FileNamed("map.png"), image));
  const std::string json = absl::StrCat(RunJson(*result).dump(2), "\n");
  RETURN_IF_ERROR(io::WriteFileAtomically(directory.FileNamed("run.json"), json));
  return io::WriteFileAtomically(directory.FileNamed("report.html"), RunReport(*result, image));
}

}  // namespace semantic_kiss::cli
