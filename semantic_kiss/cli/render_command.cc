// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"
#include "cartographer/io/map_cloud.h"
#include "cartographer/io/map_image.h"
#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_trajectory.h"
#include "cartographer/io/occupancy_grid.h"
#include "cartographer/io/point_cloud_files.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/distinct_files.h"
#include "semantic_kiss/cli/flag_list.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

namespace io = cartographer::io;

// The configured options with what the flags change.
absl::StatusOr<io::proto::RenderOptions> RenderOptions() {
  ASSIGN_OR_RETURN(const Configuration configuration, LoadConfiguration(FLAGS_config));
  io::proto::RenderOptions options = configuration.options.map_image();
  if (FLAGS_resolution > 0.) options.set_resolution_m(FLAGS_resolution);
  if (IsGiven("resolution")) options.set_cloud_resolution_m(FLAGS_resolution);
  for (const std::string& name : WordsOf(FLAGS_hide)) options.add_hide(name);
  for (const std::string& name : WordsOf(FLAGS_show)) options.add_show(name);
  return options;
}

absl::Status RenderImage() {
  ASSIGN_OR_RETURN(const io::proto::RenderOptions options, RenderOptions());
  io::MapParts parts;
  parts.node_clouds = false;
  ASSIGN_OR_RETURN(const auto map, io::ReadMapParts(FLAGS_map, parts));
  return io::WriteMapImage(map, options, FLAGS_output);
}

absl::Status RenderOccupancyGrid() {
  ASSIGN_OR_RETURN(const io::proto::RenderOptions options, RenderOptions());
  io::MapParts parts;
  parts.submap_clouds = parts.node_clouds = false;
  ASSIGN_OR_RETURN(const auto map, io::ReadMapParts(FLAGS_map, parts));
  return io::WriteOccupancyGrid(map, options, FLAGS_output);
}

absl::StatusOr<io::MapCloud> ReadCloud() {
  ASSIGN_OR_RETURN(const io::proto::RenderOptions options, RenderOptions());
  const io::CloudSource source =
      FLAGS_node_clouds ? io::CloudSource::kNodes : io::CloudSource::kSubmaps;
  return io::MapCloud::Read(FLAGS_map, source, options);
}

absl::Status RenderPly() {
  ASSIGN_OR_RETURN(const io::MapCloud cloud, ReadCloud());
  return io::WritePly(cloud, FLAGS_output);
}

absl::Status RenderPcd() {
  ASSIGN_OR_RETURN(const io::MapCloud cloud, ReadCloud());
  return io::WritePcd(cloud, FLAGS_output);
}

absl::StatusOr<io::MapTrajectory> ReadTrajectory() {
  const absl::StatusOr<std::vector<int>> ids = IntegersOf(FLAGS_trajectory);
  if (!ids.ok() || ids->size() > 1) {
    return absl::InvalidArgumentError(
        absl::StrCat("--trajectory=", FLAGS_trajectory, " is not the number of one trajectory"));
  }
  return io::ReadMapTrajectory(FLAGS_map,
                               ids->empty() ? std::nullopt : std::optional<int>(ids->front()));
}

absl::Status RenderTum() {
  ASSIGN_OR_RETURN(const io::MapTrajectory trajectory, ReadTrajectory());
  return io::WriteTumPoses(FLAGS_output, trajectory.times, trajectory.map_from_sensor);
}

absl::Status RenderKitti() {
  ASSIGN_OR_RETURN(const io::MapTrajectory trajectory, ReadTrajectory());
  return io::WriteKittiPoses(FLAGS_output, trajectory.map_from_sensor);
}

// A kind of file that maps can be rendered to.
struct Format {
  const char* ending;                // of the file's name
  std::vector<const char*> ignores;  // flags of `render` that say nothing about it
  absl::Status (*render)();
};

const std::vector<Format>& Formats() {
  static const auto& formats = *new std::vector<Format>{
      {".png", {"trajectory", "node_clouds"}, &RenderImage},
      {".pgm", {"trajectory", "node_clouds"}, &RenderOccupancyGrid},
      {".ply", {"trajectory"}, &RenderPly},
      {".pcd", {"trajectory"}, &RenderPcd},
      {".tum", {"hide", "show", "resolution", "node_clouds"}, &RenderTum},
      {"_tum.txt", {"hide", "show", "resolution", "node_clouds"}, &RenderTum},
      {".kitti", {"hide", "show", "resolution", "node_clouds"}, &RenderKitti},
      {"_kitti.txt", {"hide", "show", "resolution", "node_clouds"}, &RenderKitti}};
  return formats;
}

absl::StatusOr<Format> FormatOf(const std::string& path) {
  std::vector<std::string> known;
  for (const Format& format : Formats()) {
    if (absl::EndsWith(path, format.ending)) return format;
    known.push_back(format.ending);
  }
  return absl::InvalidArgumentError(
      absl::StrCat("--output=", path, ": the name must end in one of ", absl::StrJoin(known, ", "),
                   ", which tells what to write"));
}

absl::Status RunRender() {
  ASSIGN_OR_RETURN(const Format format, FormatOf(FLAGS_output));
  for (const char* flag : format.ignores) {
    if (!IsGiven(flag)) continue;
    return absl::InvalidArgumentError(absl::StrCat(
        "--", flag, " says nothing about files that end in ", format.ending, "; leave it out"));
  }
  RETURN_IF_ERROR(CheckOutputIsNotMap(FLAGS_map, FLAGS_output));
  return format.render();
}

}  // namespace

Command RenderCommand() {
  Command command;
  command.name = "render";
  command.summary = "draw a map, or export it as grid, points or trajectory";
  command.description =
      "Makes of a map what the ending of --output says. Maps of Cartographer will do as well. "
      "Labels that are hidden are left out: what lies beneath them shows. docs/maps.md describes "
      "the formats.";
  command.flags = {{"map", true},  {"config"},       {"hide"},       {"show"},   {"node_clouds"},
                   {"trajectory"}, {"output", true}, {"resolution"}, {"threads"}};
  command.files = {
      {"X.png",
       "The map from above in the colours of its labels, with scale, legend and trajectory."},
      {"X.pgm, X.yaml",
       "An occupancy grid for ROS's map_server: free where the ground was seen, occupied where "
       "something else was that is not moving."},
      {"X.ply, X.pcd", "All points in the map, with colour, label and certainty."},
      {"X.tum, X_tum.txt", "The trajectory in TUM's format: time, position, quaternion."},
      {"X.kitti, X_kitti.txt", "The trajectory in KITTI's format: 12 numbers a pose."}};
  command.examples = {
      {"The streets without the cars",
       "render --map=map.pbstream --output=map.png --hide=car,truck"},
      {"5 cm a pixel", "render --map=map.pbstream --output=large.png --resolution=0.05"},
      {"A grid to navigate in, in which parked cars are no obstacles",
       "render --map=map.pbstream --output=map.pgm --hide=car"},
      {"Buildings and poles as points, one in 5 cm",
       "render --map=map.pbstream --output=map.ply --show=building,pole --resolution=0.05"},
      {"Where the vehicle drove", "render --map=map.pbstream --output=trajectory.tum"}};
  command.run = &RunRender;
  return command;
}

}  // namespace semantic_kiss::cli
