// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_FLAG_LIST_H_
#define SEMANTIC_KISS_CLI_FLAG_LIST_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"

namespace semantic_kiss::cli {

// Flags that are lists: their parts stand between commas, with or without blanks around them.
// Empty parts count for nothing, so that an empty value is an empty list.

std::vector<std::string> WordsOf(absl::string_view list);

// Errors name the part that is no number of the type.
absl::StatusOr<std::vector<double>> NumbersOf(absl::string_view list);
absl::StatusOr<std::vector<int>> IntegersOf(absl::string_view list);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_FLAG_LIST_H_
