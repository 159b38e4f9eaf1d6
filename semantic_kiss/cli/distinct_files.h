// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_DISTINCT_FILES_H_
#define SEMANTIC_KISS_CLI_DISTINCT_FILES_H_

#include <string>

#include "absl/status/status.h"

namespace semantic_kiss::cli {

// An error if --output would replace the map that is read, be it by a link or another spelling.
absl::Status CheckOutputIsNotMap(const std::string& map, const std::string& output);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_DISTINCT_FILES_H_
