// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/parallel.h"
#include "cartographer/common/status.h"
#include "cartographer/io/map_reader.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/flag_list.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/output_directory.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/cli/summary_line.h"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/dataset/scan_writer.h"
#include "semantic_kiss/dataset/sequence_directory.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::map::Map;
using cartographer::map::MapNode;
using cartographer::submap::NodeId;

// The trajectory that --trajectory names, or the only one.
absl::StatusOr<int> ChosenTrajectory(const Map& map) {
  std::set<int> ids;
  for (const auto& [id, node] : map.nodes) ids.insert(id.trajectory_id);
  if (ids.empty()) return absl::NotFoundError(absl::StrCat(FLAGS_map, ": the map has no nodes"));
  const absl::StatusOr<std::vector<int>> named = IntegersOf(FLAGS_trajectory);
  const std::string known = absl::StrJoin(ids, ", ");
  if (!named.ok() || named->size() > 1 || (named->empty() && ids.size() > 1) ||
      (named->size() == 1 && ids.count(named->front()) == 0)) {
    return absl::InvalidArgumentError(absl::StrCat(FLAGS_map, " has the trajectories ", known,
                                                   "; name one of them with --trajectory"));
  }
  return named->empty() ? *ids.begin() : named->front();
}

// A directory that becomes the result once it is whole, and nothing if it never is.
class PartialDirectory {
 public:
  explicit PartialDirectory(const std::string& result)
      : result_(result), path_(absl::StrCat(result, ".partial")) {
    std::error_code error;
    std::filesystem::remove_all(path_, error);  // of a program that was killed
  }
  PartialDirectory(const PartialDirectory&) = delete;
  PartialDirectory& operator=(const PartialDirectory&) = delete;
  ~PartialDirectory() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }

  const std::string& path() const { return path_; }

  absl::Status Commit() {
    std::error_code error;
    std::filesystem::rename(path_, result_, error);
    if (!error) return absl::OkStatus();
    return absl::PermissionDeniedError(
        absl::StrCat(result_, ": cannot be made of ", path_, ": ", error.message()));
  }

 private:
  const std::string result_;
  const std::string path_;
};

absl::Status WriteDrive(const std::vector<const MapNode*>& nodes,
                        const cartographer::sensor::LabelSet& labels,
                        const std::string& directory) {
  std::vector<absl::Status> statuses(nodes.size());
  cartographer::common::ParallelChunks(nodes.size(), 1, [&](size_t i, size_t) {
    statuses[i] = StopRequested()
                      ? absl::CancelledError("nothing is written")
                      : dataset::WriteScanFiles(directory, static_cast<int>(i),
                                                dataset::FilesOf(*nodes[i]->cloud, labels));
  });
  for (const absl::Status& status : statuses) RETURN_IF_ERROR(status);
  std::vector<cartographer::common::Time> times;
  std::vector<cartographer::transform::Rigid3d> map_from_node;
  for (const MapNode* node : nodes) {
    times.push_back(node->time);
    map_from_node.push_back(node->map_from_node);
  }
  RETURN_IF_ERROR(dataset::WriteScanTimes(directory, times));
  return cartographer::io::WriteKittiPoses(absl::StrCat(directory, "/poses.txt"), map_from_node);
}

absl::Status RunScans() {
  ASSIGN_OR_RETURN(const std::string directory,
                   dataset::SequenceDirectory(FLAGS_output, FLAGS_sequence));
  std::error_code ignored;  // what cannot be asked for is not there; creating it tells why
  if (std::filesystem::exists(directory, ignored)) {
    return absl::FailedPreconditionError(
        absl::StrCat(directory, ": is there already; choose another directory or --sequence"));
  }
  cartographer::io::MapParts parts;
  parts.grids = parts.submap_clouds = false;
  ASSIGN_OR_RETURN(const Map map, cartographer::io::ReadMapParts(FLAGS_map, parts));
  ASSIGN_OR_RETURN(const int trajectory_id, ChosenTrajectory(map));
  std::vector<const MapNode*> nodes;
  size_t num_points = 0;
  for (const auto& [id, node] : map.nodes) {
    if (id.trajectory_id != trajectory_id) continue;
    nodes.push_back(&node);
    num_points += node.cloud->size();
  }
  StopInGoodOrder();
  // Gone again, as far as it was made here, if nothing comes into it.
  ASSIGN_OR_RETURN(const OutputDirectory sequences,
                   OutputDirectory::Create(absl::StrCat(FLAGS_output, "/sequences")));
  PartialDirectory partial(directory);
  RETURN_IF_ERROR(WriteDrive(nodes, map.labels, partial.path()));
  RETURN_IF_ERROR(partial.Commit());
  if (FLAGS_quiet) return absl::OkStatus();
  const Terminal terminal = Terminal::Of(STDOUT_FILENO);
  std::cout << SummaryLine(terminal, Style::kGreen, "scans",
                           absl::StrFormat("%d, with %.0f points each", nodes.size(),
                                           static_cast<double>(num_points) / nodes.size()))
            << "output    " << directory << "\n";
  return absl::OkStatus();
}

}  // namespace

Command ScansCommand() {
  Command command;
  command.name = "scans";
  command.summary = "take the scans out of a map again, as a drive";
  command.description =
      "Writes the scans that a map keeps in its nodes as a sequence in SemanticKITTI's layout: to "
      "localize them in another map, to drive them again with other options, or to look at their "
      "labels, when the recording itself is gone. They are as thin as the map keeps them; "
      "poses.txt "
      "has their poses in the map.\n\n"
      "They were corrected when they were mapped: read them with "
      "dataset.vertical_correction_deg = 0.";
  command.flags = {{"map", true}, {"trajectory"}, {"sequence"},
                   {"threads"},   {"quiet"},      {"output", true}};
  command.files = {{"sequences/NN/velodyne/*.bin", "Points: x, y, z and remission."},
                   {"sequences/NN/labels/*.label", "Their classes; not for maps without labels."},
                   {"sequences/NN/confidences/*.conf", "The certainties of the labels."},
                   {"sequences/NN/times.txt", "Seconds of the scans."},
                   {"sequences/NN/poses.txt", "Poses of the lidar in the map, 12 numbers a line."}};
  command.examples = {
      {"The drive of a map, as a data set", "scans --map=map.pbstream --output=data"}};
  command.run = &RunScans;
  return command;
}

}  // namespace semantic_kiss::cli
