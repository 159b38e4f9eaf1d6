// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_MANUAL_OPTION_UNIT_H_
#define SEMANTIC_KISS_MANUAL_OPTION_UNIT_H_

#include <string>

#include "absl/strings/string_view.h"

namespace semantic_kiss::manual {

// The unit that the end of an option's name tells: "m" for max_range_m, "1/m" for
// translation_weight_per_m, "m per m" for linear_m_per_m; empty for counts, shares and words.
std::string UnitOf(absl::string_view option);

}  // namespace semantic_kiss::manual

#endif  // SEMANTIC_KISS_MANUAL_OPTION_UNIT_H_
