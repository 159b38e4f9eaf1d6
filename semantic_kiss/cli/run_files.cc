// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_files.h"

#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/map_image.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/cli/run_json.h"
#include "semantic_kiss/cli/run_report.h"
#include "semantic_kiss/report/html_report.h"
#include "semantic_kiss/report/json_text.h"
#include "semantic_kiss/report/map_layers.h"

namespace semantic_kiss::cli {

namespace io = cartographer::io;

absl::Status WriteRunFiles(const OutputDirectory& directory, const proto::RunOptions& options,
                           RunResult* result) {
  StageTimes& times = result->drive.stage_times;
  cartographer::common::Stopwatch stopwatch;
  // First, because a drive without anything to draw is to leave no files at all.
  ASSIGN_OR_RETURN(const std::string image, io::RenderMapImage(result->map, options.map_image()));
  times.Add("map_image", stopwatch.Lap());
  ASSIGN_OR_RETURN(auto layers,
                   report::TakeApart({&result->map}, options.map_image(), options.report()));
  times.Add("report_map", stopwatch.Lap());
  io::AtomicFileSet files;
  const auto file = [&](const char* name) {
    return io::Destination(directory.FileNamed(name), &files);
  };
  RETURN_IF_ERROR(io::WriteMap(result->map, file("map.pbstream")));
  times.Add("map_file", stopwatch.Lap());
  RETURN_IF_ERROR(io::WriteKittiPoses(file("odometry_kitti.txt"), result->odometry));
  RETURN_IF_ERROR(io::WriteKittiPoses(file("trajectory_kitti.txt"), result->trajectory));
  RETURN_IF_ERROR(
      io::WriteTumPoses(file("trajectory_tum.txt"), result->times, result->map_from_lidar));
  RETURN_IF_ERROR(io::WriteFileAtomically(file("map.png"), image));
  const std::string json = absl::StrCat(report::JsonText(RunJson(*result), 2), "\n");
  RETURN_IF_ERROR(io::WriteFileAtomically(file("run.json"), json));
  RETURN_IF_ERROR(io::WriteFileAtomically(
      file("report.html"), report::Html(RunReport(*result, std::move(layers.front())))));
  return files.Commit();
}

}  // namespace semantic_kiss::cli
