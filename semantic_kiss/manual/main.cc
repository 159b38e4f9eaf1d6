// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// write_manual DESCRIPTORS CONFIGURATION_FILES OUTPUT: writes what is generated from the
// declarations of commands, flags and options to the directory OUTPUT. DESCRIPTORS are all messages
// with their comments (option_comments.h), CONFIGURATION_FILES is the directory of the Lua files.

#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/version.h"
#include "semantic_kiss/manual/man_page.h"
#include "semantic_kiss/manual/option_comments.h"
#include "semantic_kiss/manual/option_reference.h"
#include "semantic_kiss/manual/shell_completion.h"
#include "semantic_kiss/manual/shipped_options.h"

namespace semantic_kiss::manual {
namespace {

absl::Status WriteManual(const std::string& descriptors, const std::string& configuration_files,
                         const std::string& output) {
  ASSIGN_OR_RETURN(const OptionComments comments, OptionComments::Read(descriptors));
  ASSIGN_OR_RETURN(const std::vector<OptionTree> trees, LoadShippedOptions(configuration_files));
  ASSIGN_OR_RETURN(const std::string options, OptionReference(trees, comments));
  const std::vector<std::pair<std::string, std::string>> files = {
      {"options.md", options},
      {"semantic_kiss.1", ManPage(cli::Commands(), cli::Version())},
      {"semantic_kiss.bash", BashCompletion(cli::Commands())},
      {"_semantic_kiss", ZshCompletion(cli::Commands())}};
  std::filesystem::create_directories(output);
  for (const auto& [name, content] : files) {
    RETURN_IF_ERROR(cartographer::io::WriteFileAtomically(output + "/" + name, content));
  }
  return absl::OkStatus();
}

}  // namespace
}  // namespace semantic_kiss::manual

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: write_manual DESCRIPTORS CONFIGURATION_FILES OUTPUT" << std::endl;
    return 2;
  }
  const absl::Status status = semantic_kiss::manual::WriteManual(argv[1], argv[2], argv[3]);
  if (status.ok()) return 0;
  std::cerr << "error: " << status.message() << std::endl;
  return 1;
}
