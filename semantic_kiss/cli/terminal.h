// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_TERMINAL_H_
#define SEMANTIC_KISS_CLI_TERMINAL_H_

#include <string>

#include "absl/strings/string_view.h"

namespace semantic_kiss::cli {

// What an output stream can show.
struct Terminal {
  bool interactive = false;  // a person watches: lines may be overwritten
  bool colors = false;
  int width = 80;  // columns, > 0

  // Of a file descriptor. Colours need a terminal that is not "dumb" and no NO_COLOR
  // (https://no-color.org).
  static Terminal Of(int descriptor);
};

enum class Style { kBold, kDim, kGreen, kYellow, kRed };

// `text` in this style where the terminal has colours, else as it is.
std::string Styled(const Terminal& terminal, Style style, absl::string_view text);

// Breaks paragraphs (separated by empty lines) at blanks so that lines have at most `width`
// columns, each indented by `indent` blanks. A word longer than a line stays whole. No newline at
// the end.
std::string Wrapped(absl::string_view text, int indent, int width);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_TERMINAL_H_
