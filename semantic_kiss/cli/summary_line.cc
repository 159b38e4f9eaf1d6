// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/summary_line.h"

#include <limits>

#include "absl/strings/str_cat.h"

namespace semantic_kiss::cli {

std::string SummaryLine(const Terminal& terminal, Style style, absl::string_view heading,
                        const std::string& text) {
  constexpr int kColumn = 10;
  const int width = terminal.interactive ? terminal.width : std::numeric_limits<int>::max();
  return absl::StrCat(Styled(terminal, style, heading),
                      Wrapped(text, kColumn, width).substr(heading.size()), "\n");
}

}  // namespace semantic_kiss::cli
