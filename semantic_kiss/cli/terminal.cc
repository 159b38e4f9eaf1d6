// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"

namespace semantic_kiss::cli {
namespace {

bool HasValue(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && value[0] != '\0';
}

bool IsDumb() {
  const char* term = std::getenv("TERM");
  return term == nullptr || absl::string_view(term) == "dumb";
}

const char* EscapeCode(Style style) {
  switch (style) {
    case Style::kBold:
      return "\033[1m";
    case Style::kDim:
      return "\033[2m";
    case Style::kGreen:
      return "\033[32m";
    case Style::kYellow:
      return "\033[33m";
    case Style::kRed:
      return "\033[31m";
  }
  return "";
}

std::string WrapParagraph(absl::string_view paragraph, int indent, int width) {
  std::string lines;
  std::string line;
  for (const absl::string_view word :
       absl::StrSplit(paragraph, absl::ByAnyChar(" \n"), absl::SkipEmpty())) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > static_cast<size_t>(width)) {
      absl::StrAppend(&lines, std::string(indent, ' '), line, "\n");
      line.clear();
    }
    absl::StrAppend(&line, line.empty() ? "" : " ", word);
  }
  return absl::StrCat(lines, std::string(indent, ' '), line);
}

}  // namespace

Terminal Terminal::Of(int descriptor) {
  Terminal terminal;
  terminal.interactive = ::isatty(descriptor) != 0;
  if (!terminal.interactive) return terminal;
  terminal.colors = !HasValue("NO_COLOR") && !IsDumb();
  winsize size{};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) terminal.width = size.ws_col;
  return terminal;
}

std::string Styled(const Terminal& terminal, Style style, absl::string_view text) {
  if (!terminal.colors) return std::string(text);
  return absl::StrCat(EscapeCode(style), text, "\033[0m");
}

std::string Wrapped(absl::string_view text, int indent, int width) {
  std::vector<std::string> paragraphs;
  for (const absl::string_view paragraph : absl::StrSplit(text, "\n\n")) {
    paragraphs.push_back(WrapParagraph(paragraph, indent, width));
  }
  return absl::StrJoin(paragraphs, "\n\n");
}

}  // namespace semantic_kiss::cli
