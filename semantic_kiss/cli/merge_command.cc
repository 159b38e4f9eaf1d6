// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <unistd.h>

#include <iostream>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/slam/merge_maps.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/distinct_files.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/loaded_map.h"
#include "semantic_kiss/cli/summary_line.h"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/cli/version.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::map::Map;
using cartographer::slam::MergedMap;

absl::Status RunMerge() {
  RETURN_IF_ERROR(CheckOutputIsNotMap(FLAGS_map, FLAGS_output));
  RETURN_IF_ERROR(CheckOutputIsNotMap(FLAGS_other_map, FLAGS_output));
  ASSIGN_OR_RETURN(const Configuration configuration,
                   LoadConfiguration(IsGiven("config") ? FLAGS_config : "semantic_kiss_6dof.lua"));
  ASSIGN_OR_RETURN(const Map first, LoadMapFor(configuration.labels, FLAGS_map, {}));
  ASSIGN_OR_RETURN(Map second, LoadMapFor(configuration.labels, FLAGS_other_map, {}));
  ASSIGN_OR_RETURN(auto pose_graph, cartographer::pose_graph::PoseGraph::Create(
                                        configuration.options.pose_graph(), configuration.labels));
  auto merged = cartographer::slam::MergeMaps(first, std::move(second), configuration.labels,
                                              std::move(pose_graph));
  RETURN_IF_ERROR(cartographer::common::AddContext(merged.status(),
                                                   absl::StrCat(FLAGS_map, ", ", FLAGS_other_map)));
  merged->map.history.push_back(absl::StrCat(
      "semantic_kiss ", Version(), " merge: ", merged->closures.size(), " closures join the two"));
  RETURN_IF_ERROR(cartographer::io::WriteMap(merged->map, FLAGS_output));
  if (FLAGS_quiet) return absl::OkStatus();
  const Terminal terminal = Terminal::Of(STDOUT_FILENO);
  std::cout << SummaryLine(terminal, Style::kGreen, "joined",
                           absl::StrFormat("by %d closures", merged->closures.size()))
            << SummaryLine(terminal, Style::kBold, "map",
                           absl::StrFormat("%d nodes, %d submaps", merged->map.nodes.size(),
                                           merged->map.submaps.size()))
            << "output    " << FLAGS_output << "\n";
  return absl::OkStatus();
}

}  // namespace

Command MergeCommand() {
  Command command;
  command.name = "merge";
  command.summary = "join two maps that overlap";
  command.description =
      "Searches for places that both maps show, ties them by loop closures, and writes one map "
      "with the trajectories of both, in the frame of the first. Neither needs to know where the "
      "other is. Fails if nothing joins them.";
  command.flags = {{"map", true}, {"other_map", true}, {"config", false, "semantic_kiss_6dof.lua"},
                   {"threads"},   {"quiet"},           {"output", true}};
  command.examples = {{"Two drives of one town",
                       "merge --map=monday.pbstream --other_map=tuesday.pbstream "
                       "--output=town.pbstream"}};
  command.run = &RunMerge;
  return command;
}

}  // namespace semantic_kiss::cli
