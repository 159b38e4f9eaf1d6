// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_ARGUMENTS_H_
#define SEMANTIC_KISS_CLI_ARGUMENTS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "semantic_kiss/cli/command.h"

namespace semantic_kiss::cli {

// What the user asked for.
struct Invocation {
  enum class Kind { kRun, kHelp, kVersion };
  Kind kind = Kind::kRun;
  const Command* command = nullptr;  // of `commands`; null for help on everything and for version
};

// Reads a command line (without the program's name) of the form `COMMAND --flag=value ...` and
// sets the flags that it names. Also understood: `--flag value`, `--boolean`, `--noboolean`,
// `--boolean=false`, `--help` or `-h` anywhere, `help COMMAND`, `--version`. Of a repeated flag
// the last value holds.
//
// Errors (kInvalidArgument) are mistakes of usage: no or an unknown command, a flag that the
// command does not take, a value that is missing, mistyped or too small, a required flag that is
// absent. They name the nearest name that exists.
absl::StatusOr<Invocation> ParseArguments(const std::vector<Command>& commands,
                                          const std::vector<std::string>& arguments);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_ARGUMENTS_H_
