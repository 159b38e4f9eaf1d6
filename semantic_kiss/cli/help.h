// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_HELP_H_
#define SEMANTIC_KISS_CLI_HELP_H_

#include <string>
#include <vector>

#include "semantic_kiss/cli/command.h"
#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::cli {

// The overview of all commands, for `semantic_kiss --help`.
std::string OverviewHelp(const std::vector<Command>& commands, const Terminal& terminal);

// Everything about a command, for `semantic_kiss COMMAND --help`: usage, description, flags by
// group with their defaults, examples.
std::string CommandHelp(const Command& command, const Terminal& terminal);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_HELP_H_
