// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/distinct_files.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"

namespace semantic_kiss::cli {

absl::Status CheckOutputIsNotMap(const std::string& map, const std::string& output) {
  std::error_code ignored;  // files that do not exist are not the same
  if (!std::filesystem::equivalent(map, output, ignored)) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat("--output: ", output,
                                                 " is the map itself, which would be lost; name "
                                                 "another place"));
}

}  // namespace semantic_kiss::cli
