// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_COMMAND_H_
#define SEMANTIC_KISS_CLI_COMMAND_H_

#include <string>
#include <vector>

#include "absl/status/status.h"

namespace semantic_kiss::cli {

// A flag that a command takes; what the flag is stands in flags.h.
struct FlagUse {
  std::string name;
  bool required = false;
  std::string default_text{};  // where this command's default is another than the flag's
};

struct OutputFile {
  std::string name;
  std::string what;
};

struct Example {
  std::string what;
  std::string arguments;  // what follows the program's name
};

// A command declared as data: the parser, --help, the manual page and shell completion all read
// this one declaration.
struct Command {
  std::string name;
  std::string summary;      // one line for the overview of all commands
  std::string description;  // paragraphs for --help, separated by empty lines
  std::vector<FlagUse> flags;
  std::vector<OutputFile> files;  // what the command writes, where that is several files
  std::vector<Example> examples;

  // Does the work; flags hold their values already. The program turns an error into one line on
  // stderr and exit code 1; kCancelled means that a signal stopped the command in good order.
  absl::Status (*run)();
};

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_COMMAND_H_
