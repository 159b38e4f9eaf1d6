// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <iostream>

#include "cartographer/common/status.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

absl::Status RunConfig() {
  ASSIGN_OR_RETURN(const Configuration configuration, LoadConfiguration(FLAGS_config));
  std::cout << configuration.lua;
  return absl::OkStatus();
}

}  // namespace

Command ConfigCommand() {
  Command command;
  command.name = "config";
  command.summary = "print the resolved configuration";
  command.description =
      "Loads a configuration with everything that it includes, checks it as `run` would, and "
      "prints the result as one Lua file that gives the same configuration again.";
  command.flags = {{"config"}};
  command.examples = {
      {"Every option of the default system with its value", "config"},
      {"Keep what a run used, to change it", "config --config=kiss_icp.lua > mine.lua"}};
  command.run = &RunConfig;
  return command;
}

}  // namespace semantic_kiss::cli
