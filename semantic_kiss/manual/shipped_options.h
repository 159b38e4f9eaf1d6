// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_MANUAL_SHIPPED_OPTIONS_H_
#define SEMANTIC_KISS_MANUAL_SHIPPED_OPTIONS_H_

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "google/protobuf/message.h"

namespace semantic_kiss::manual {

// The options that a Lua file resolves to.
struct OptionFile {
  std::string name;  // relative to the directory of configuration files
  std::unique_ptr<google::protobuf::Message> options;
};

// The options that some commands share: one message, its defaults, and the files that begin with
// these and change some.
struct OptionTree {
  std::string commands;  // "run, relocalize"
  std::string example;   // a Lua file that changes one of them
  OptionFile defaults;
  std::vector<OptionFile> systems;  // by name
};

// All options, as the Lua files of a directory have them: of a run, of the simulator, of filters.
absl::StatusOr<std::vector<OptionTree>> LoadShippedOptions(const std::string& directory);

}  // namespace semantic_kiss::manual

#endif  // SEMANTIC_KISS_MANUAL_SHIPPED_OPTIONS_H_
