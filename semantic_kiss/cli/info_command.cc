// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <iostream>

#include "cartographer/common/status.h"
#include "cartographer/io/map_summary.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/map_info.h"
#include "semantic_kiss/report/json_text.h"

namespace semantic_kiss::cli {
namespace {

absl::Status RunInfo() {
  ASSIGN_OR_RETURN(const cartographer::io::MapSummary summary,
                   cartographer::io::ReadMapSummary(FLAGS_map));
  if (FLAGS_json) {
    std::cout << report::JsonText(MapInfoJson(summary), 2) << std::endl;
  } else {
    std::cout << MapInfoText(summary);
  }
  return absl::OkStatus();
}

}  // namespace

Command InfoCommand() {
  Command command;
  command.name = "info";
  command.summary = "tell what is in a map";
  command.description =
      "Prints what a pbstream file holds: trajectories, submaps, constraints, labels with their "
      "counts, extent, history, and the records by kind. Files of Cartographer are understood as "
      "well. The file is read in one pass; it need not fit into memory.";
  command.flags = {{"map", true}, {"json"}};
  command.examples = {{"For people", "info --map=output/map.pbstream"},
                      {"The configuration that made the map",
                       "info --map=output/map.pbstream --json | jq -r .configuration"}};
  command.run = &RunInfo;
  return command;
}

}  // namespace semantic_kiss::cli
