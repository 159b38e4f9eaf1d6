// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
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
#include "semantic_kiss/cli/map_report.h"
#include "semantic_kiss/report/html_report.h"

namespace semantic_kiss::cli {
namespace {

namespace io = cartographer::io;

// The configured options with what the flags change.
io::proto::RenderOptions WithFlags(const Configuration& configuration) {
  io::proto::RenderOptions options = configuration.options.map_image();
  if (FLAGS_resolution > 0.) options.set_resolution_m(FLAGS_resolution);
  if (IsGiven("resolution")) options.set_cloud_resolution_m(FLAGS_resolution);
  for (const std::string& name : WordsOf(FLAGS_hide)) options.add_hide(name);
  for (const std::string& name : WordsOf(FLAGS_show)) options.add_show(name);
  return options;
}

absl::StatusOr<io::proto::RenderOptions> RenderOptions() {
  ASSIGN_OR_RETURN(const Configuration configuration, LoadConfiguration(FLAGS_config));
  return WithFlags(configuration);
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

absl::StatusOr<NamedMap> ReadNamed(const std::string& path) {
  io::MapParts parts;
  parts.node_clouds = false;
  ASSIGN_OR_RETURN(auto map, io::ReadMapParts(path, parts));
  return NamedMap{std::filesystem::path(path).filename().string(), std::move(map)};
}

absl::Status RenderHtml() {
  ASSIGN_OR_RETURN(const Configuration configuration, LoadConfiguration(FLAGS_config));
  report::proto::ReportOptions options = configuration.options.report();
  if (FLAGS_resolution > 0.) options.set_resolution_m(FLAGS_resolution);
  std::vector<NamedMap> maps;
  for (const std::string& path : {FLAGS_map, FLAGS_compare}) {
    if (path.empty()) continue;
    ASSIGN_OR_RETURN(NamedMap map, ReadNamed(path));
    maps.push_back(std::move(map));
  }
  ASSIGN_OR_RETURN(const report::Report page, MapReport(maps, WithFlags(configuration), options));
  return io::WriteFileAtomically(FLAGS_output, report::Html(page));
}

// A kind of file that maps can be rendered to.
struct Format {
  const char* ending;                // of the file's name
  std::vector<const char*> ignores;  // flags of `render` that say nothing about it
  absl::Status (*render)();
};

const std::vector<Format>& Formats() {
  static const std::vector<const char*> kOfPictures = {"trajectory", "node_clouds", "compare"};
  static const std::vector<const char*> kOfClouds = {"trajectory", "compare"};
  static const std::vector<const char*> kOfPoses = {"hide", "show", "resolution", "node_clouds",
                                                    "compare"};
  static const auto& formats =
      *new std::vector<Format>{{".png", kOfPictures, &RenderImage},
                               {".html", {"trajectory", "node_clouds"}, &RenderHtml},
                               {".pgm", kOfPictures, &RenderOccupancyGrid},
                               {".ply", kOfClouds, &RenderPly},
                               {".pcd", kOfClouds, &RenderPcd},
                               {".tum", kOfPoses, &RenderTum},
                               {"_tum.txt", kOfPoses, &RenderTum},
                               {".kitti", kOfPoses, &RenderKitti},
                               {"_kitti.txt", kOfPoses, &RenderKitti}};
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
  RETURN_IF_ERROR(CheckOutputIsNotMap(FLAGS_compare, FLAGS_output));
  return format.render();
}

}  // namespace

Command RenderCommand() {
  Command command;
  command.name = "render";
  command.summary = "draw a map, or export it as page, grid, points or trajectory";
  command.description =
      "Makes of a map what the ending of --output says. Maps of Cartographer will do as well. "
      "Labels that are hidden are left out: what lies beneath them shows. docs/maps.md describes "
      "the formats.";
  command.flags = {{"map", true},   {"compare"},    {"config"},       {"hide"},       {"show"},
                   {"node_clouds"}, {"trajectory"}, {"output", true}, {"resolution"}, {"threads"}};
  command.files = {
      {"X.png",
       "The map from above in the colours of its labels, with scale, legend and trajectory."},
      {"X.html",
       "A page to look at the map in a browser: a layer for each label, to hide or to fade; two "
       "maps "
       "side by side with --compare."},
      {"X.pgm, X.yaml",
       "An occupancy grid for ROS's map_server: free where the ground was seen, occupied where "
       "something else was that is not moving."},
      {"X.ply, X.pcd", "All points in the map, with colour, label and certainty."},
      {"X.tum, X_tum.txt", "The trajectory in TUM's format: time, position, quaternion."},
      {"X.kitti, X_kitti.txt", "The trajectory in KITTI's format: 12 numbers a pose."}};
  command.examples = {
      {"The streets without the cars",
       "render --map=map.pbstream --output=map.png --hide=car,truck"},
      {"What a filter did, side by side in a browser",
       "render --map=map.pbstream --compare=lasting.pbstream --output=both.html"},
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
