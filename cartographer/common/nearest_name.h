// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_NEAREST_NAME_H_
#define CARTOGRAPHER_COMMON_NEAREST_NAME_H_

#include <string>
#include <vector>

#include "absl/strings/string_view.h"

namespace cartographer::common {

// Levenshtein distance: the fewest characters to insert, delete or replace to get from a to b.
int EditDistance(absl::string_view a, absl::string_view b);

// The candidate with the smallest edit distance to `name`, the first of equals; empty without
// candidates. For "did you mean ...?" in errors.
std::string NearestName(absl::string_view name, const std::vector<std::string>& candidates);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_NEAREST_NAME_H_
