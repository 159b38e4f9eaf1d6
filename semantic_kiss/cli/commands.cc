// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/commands.h"

namespace semantic_kiss::cli {

const std::vector<Command>& Commands() {
  static const auto& commands = *new std::vector<Command>{
      RunCommand(),    RelocalizeCommand(), SimulateCommand(), EvaluateCommand(), InfoCommand(),
      FilterCommand(), MergeCommand(),      ScansCommand(),    RenderCommand(),   ConfigCommand(),
  };
  return commands;
}

}  // namespace semantic_kiss::cli
