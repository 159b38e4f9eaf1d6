// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_MANUAL_OPTION_REFERENCE_H_
#define SEMANTIC_KISS_MANUAL_OPTION_REFERENCE_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "semantic_kiss/manual/option_comments.h"
#include "semantic_kiss/manual/shipped_options.h"

namespace semantic_kiss::manual {

// docs/options.md: every option of the trees with its key, default, type, range, unit and meaning,
// and what the systems make of it; a section for each table of options, in the order in which the
// messages declare them.
//
// Error: options and tables without a comment, by the full names of their fields.
absl::StatusOr<std::string> OptionReference(const std::vector<OptionTree>& trees,
                                            const OptionComments& comments);

}  // namespace semantic_kiss::manual

#endif  // SEMANTIC_KISS_MANUAL_OPTION_REFERENCE_H_
