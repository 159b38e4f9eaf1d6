// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <unistd.h>

#include <iostream>
#include <memory>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/pose_graph/pose_graph.h"
#include "cartographer/slam/graph_of_map.h"
#include "cartographer/slam/map_builder.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/distinct_files.h"
#include "semantic_kiss/cli/drive.h"
#include "semantic_kiss/cli/drive_flags.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/live_run.h"
#include "semantic_kiss/cli/loaded_map.h"
#include "semantic_kiss/cli/output_directory.h"
#include "semantic_kiss/cli/progress.h"
#include "semantic_kiss/cli/run_files.h"
#include "semantic_kiss/cli/run_result.h"
#include "semantic_kiss/cli/run_summary.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/cli/trace_text.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::map::Map;
using cartographer::slam::MapBuilder;

absl::StatusOr<std::unique_ptr<MapBuilder>> MakeMapBuilder(const Configuration& configuration,
                                                           const Map* earlier) {
  ASSIGN_OR_RETURN(auto builder, MakeLocalTrajectoryBuilder(configuration));
  ASSIGN_OR_RETURN(auto pose_graph, cartographer::pose_graph::PoseGraph::Create(
                                        configuration.options.pose_graph(), configuration.labels));
  if (earlier == nullptr) {
    return std::make_unique<MapBuilder>(std::move(builder), std::move(pose_graph),
                                        configuration.labels);
  }
  pose_graph->AddMap(FLAGS_freeze_map ? cartographer::slam::FrozenGraphOf(*earlier)
                                      : cartographer::slam::GraphOf(*earlier));
  return std::make_unique<MapBuilder>(std::move(builder), std::move(pose_graph),
                                      configuration.labels,
                                      cartographer::slam::NextTrajectoryId(*earlier));
}

// The map that the drive goes on with; nullptr for a new one.
absl::StatusOr<std::unique_ptr<const Map>> LoadEarlierMap(const Configuration& configuration) {
  if (FLAGS_map.empty()) return nullptr;
  if (configuration.options.pose_graph().optimize_every_n_nodes() == 0) {
    return absl::InvalidArgumentError(absl::StrCat(
        "--map needs loop closures to join the drive to it, and ", FLAGS_config,
        " closes none; take --config=semantic_kiss_6dof.lua or semantic_kiss_loop_closure.lua"));
  }
  ASSIGN_OR_RETURN(Map map, LoadMapFor(configuration.labels, FLAGS_map, {}));
  return std::make_unique<const Map>(std::move(map));
}

// The history of a map that a drive was added to.
void Continue(const Map& earlier, int trajectory_id, Map* map) {
  map->history.insert(map->history.begin(), earlier.history.begin(), earlier.history.end());
  map->history.back() += absl::StrCat(" run --map: added trajectory ", trajectory_id);
}

absl::Status NotJoined() {
  return absl::FailedPreconditionError(absl::StrCat("no place of the drive was recognized in ",
                                                    FLAGS_map,
                                                    ", so nothing joins them; nothing is written"));
}

absl::Status Stopped(const DriveRecord& drive, const dataset::ScanSource& scans) {
  const std::string how_far =
      absl::StrCat("after ", drive.num_scans, " of ", scans.size(), " scans; ");
  return absl::CancelledError(absl::StrCat(
      how_far, drive.num_scans == 0
                   ? "nothing is written"
                   : absl::StrCat("trajectory and map of these are whole in ", FLAGS_output)));
}

void Tell(const RunResult& result, const OutputDirectory& directory) {
  const Terminal terminal = Terminal::Of(STDOUT_FILENO);
  for (const TracedScan& traced : result.drive.traces) {
    std::cout << TraceText(traced, result.map.labels, terminal);
  }
  std::cout << RunSummary(result, directory.path(), terminal);
}

absl::Status RunRun() {
  ASSIGN_OR_RETURN(const std::set<int> scans_to_trace, ScansToTrace(FLAGS_trace_scan));
  ASSIGN_OR_RETURN(const Configuration configuration, LoadConfiguration(FLAGS_config));
  ASSIGN_OR_RETURN(const auto scans, OpenScans(configuration));
  RETURN_IF_ERROR(CheckOutputIsNotMap(FLAGS_map, absl::StrCat(FLAGS_output, "/map.pbstream")));
  ASSIGN_OR_RETURN(const auto earlier, LoadEarlierMap(configuration));
  ASSIGN_OR_RETURN(const auto map_builder, MakeMapBuilder(configuration, earlier.get()));
  ASSIGN_OR_RETURN(const OutputDirectory directory, OutputDirectory::Create(FLAGS_output));

  ASSIGN_OR_RETURN(const auto live, LiveRun::Start(FLAGS_live, configuration.labels, directory));
  StopInGoodOrder();
  ProgressReporter progress = MakeProgressReporter(scans->size());
  ASSIGN_OR_RETURN(DriveRecord drive, Drive(scans.get(), map_builder.get(),
                                            {&progress, scans_to_trace, live->board()}));
  live->Concluding();
  progress.Announce("last loop closures ...");
  if (drive.num_scans == 0) return Stopped(drive, *scans);

  ASSIGN_OR_RETURN(RunResult result,
                   Conclude(configuration, std::move(drive), *scans, map_builder.get()));
  if (earlier != nullptr) {
    if (!map_builder->IsTied()) return NotJoined();
    Continue(*earlier, map_builder->trajectory_id(), &result.map);
  }
  progress.Announce("map, pictures and report ...");
  RETURN_IF_ERROR(WriteRunFiles(directory, configuration.options, &result));
  progress.Announce("");
  if (!FLAGS_quiet) Tell(result, directory);
  const bool complete = result.drive.num_scans == result.scans_available;
  live->End(complete);
  return complete ? absl::OkStatus() : Stopped(result.drive, *scans);
}

}  // namespace

Command RunCommand() {
  Command command;
  command.name = "run";
  command.summary = "SLAM over a sequence of scans: trajectory, map, picture, report";
  command.description =
      "Estimates the trajectory of a sequence in SemanticKITTI's format by semantic KISS-ICP, "
      "builds submaps with a layer for every label, and writes trajectory, map, picture and "
      "report to --output.\n\n"
      "With --map the drive is added to a map that is there, as a trajectory of its own, joined to "
      "it where places are recognized. The map's file stays; the result is written to --output.\n\n"
      "Ctrl-C or SIGTERM ends the drive after the current scan; the files are then written for "
      "the scans so far and the exit code is 130 or 143. A second one ends at once and leaves the "
      "files as they were.";
  command.flags = {{"config"},    {"dataset", true}, {"sequence"},     {"labels_dir"},
                   {"map"},       {"freeze_map"},    {"ground_truth"}, {"first_scan"},
                   {"num_scans"}, {"trace_scan"},    {"output", true}, {"threads"},
                   {"live"},      {"quiet"}};
  command.files = {
      {"odometry_kitti.txt",
       "Poses as the odometry saw the drive, 12 numbers a line; of the camera "
       "if calib.txt has the row Tr, else of the lidar."},
      {"trajectory_kitti.txt", "The same as the map has it."},
      {"trajectory_tum.txt", "Time, position and quaternion of the lidar, as the map has it."},
      {"map.pbstream", "The map; Cartographer opens it, too."},
      {"map.png", "Its picture."},
      {"report.html", "All of it on one page."},
      {"run.json", "Figures for scripts: time of the stages, memory, accuracy, configuration."}};
  command.examples = {
      {"A whole sequence", "run --dataset=kitti/dataset --sequence=00 --output=output/00"},
      {"Labels of a network, the first 100 scans",
       "run --dataset=kitti/dataset --labels_dir=predictions --num_scans=100 --output=output"},
      {"Another drive through a map that is there, joined to it",
       "run --config=semantic_kiss_6dof.lua --map=map.pbstream --dataset=data --sequence=01 "
       "--output=output/both"},
      {"With a page that shows how far it is",
       "run --dataset=kitti/dataset --live --output=output/00"},
      {"What every stage makes of two of the scans",
       "run --dataset=kitti/dataset --trace_scan=120,450 --output=output/00"},
      {"The baseline without labels",
       "run --config=kiss_icp.lua --dataset=kitti/dataset --output=output/kiss_icp"}};
  command.run = &RunRun;
  return command;
}

}  // namespace semantic_kiss::cli
