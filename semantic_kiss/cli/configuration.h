// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_CONFIGURATION_H_
#define SEMANTIC_KISS_CLI_CONFIGURATION_H_

#include <string>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/cli/proto/run_options.pb.h"

namespace semantic_kiss::cli {

// A configuration file with all that it refers to.
struct Configuration {
  proto::RunOptions options;
  cartographer::sensor::LabelSet labels;
  std::string lua;  // the options, resolved: a Lua file that needs no other
};

// Where the program's own Lua files are: share/semantic_kiss/configuration_files beside the folder
// of the executable, as well installed as in the build tree.
std::string InstalledConfigurationDirectory();

// Loads the configuration `file`: a path, or the name of a file of the installed directory. What
// it includes, the label set as well, is looked for beside it first and in that directory then.
absl::StatusOr<Configuration> LoadConfiguration(const std::string& file);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_CONFIGURATION_H_
