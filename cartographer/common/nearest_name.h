// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_NEAREST_NAME_H_
#define CARTOGRAPHER_COMMON_NEAREST_NAME_H_

#include <cstddef>
#include <string>
#include <vector>

#include "absl/strings/string_view.h"

namespace cartographer::common {

// For error messages about names that do not exist: which of those that do was meant?

// The smallest number of single-character insertions, deletions, replacements and swaps of
// neighbours that turns `a` into `b` (optimal string alignment). Bytes are compared, ASCII letters
// without regard to case. O(|a| |b|) time.
int EditDistance(absl::string_view a, absl::string_view b);

// At most `max_names` of `known`, the nearest to `name` first; ties stay in the order of `known`.
// A name that contains `name`, or is contained in it, counts as one edit away.
std::vector<std::string> NearestNames(absl::string_view name, const std::vector<std::string>& known,
                                      size_t max_names);

// The nearest of `known`, the first of equals; empty if there are none.
std::string NearestName(absl::string_view name, const std::vector<std::string>& known);

// The remedy part of an error message, to follow "; ": `did you mean "pole"?` if one of `known` is
// so near that a slip explains it, else a list of the nearest: `known: "pole", "car", ...`.
std::string SuggestName(absl::string_view name, const std::vector<std::string>& known);

// "a", "b", "c" - quoted, separated by commas.
std::string QuotedList(const std::vector<std::string>& names);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_NEAREST_NAME_H_
