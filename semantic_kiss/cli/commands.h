// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_COMMANDS_H_
#define SEMANTIC_KISS_CLI_COMMANDS_H_

#include <vector>

#include "semantic_kiss/cli/command.h"

namespace semantic_kiss::cli {

// All commands, in the order of the overview.
const std::vector<Command>& Commands();

// One file a command: <name>_command.cc.
Command ConfigCommand();
Command EvaluateCommand();
Command FilterCommand();
Command InfoCommand();
Command MergeCommand();
Command ScansCommand();
Command RelocalizeCommand();
Command RenderCommand();
Command RunCommand();
Command SimulateCommand();

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_COMMANDS_H_
