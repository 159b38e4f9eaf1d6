// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/help.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "semantic_kiss/cli/flag_text.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

// Wide terminals do not make long lines readable; narrower ones than this wrap by themselves.
constexpr int kMaxWidth = 100;
constexpr int kMinWidth = 30;
constexpr int kIndent = 2;

int TextWidth(const Terminal& terminal) { return std::clamp(terminal.width, kMinWidth, kMaxWidth); }

// A term and what it means: side by side where there is room, else one below the other.
std::string Entry(const std::string& term, const std::string& meaning, int column, int width) {
  if (width < 2 * column) {
    return absl::StrCat("  ", term, "\n", Wrapped(meaning, 3 * kIndent, width), "\n");
  }
  const std::string text = Wrapped(meaning, column, width);
  const int used = kIndent + static_cast<int>(term.size());
  if (used + kIndent > column) return absl::StrCat("  ", term, "\n", text, "\n");
  return absl::StrCat("  ", term, text.substr(used), "\n");
}

std::string FlagsOfGroup(const Command& command, FlagGroup group, const Terminal& terminal) {
  std::string entries;
  for (const FlagUse& use : UsesOfGroup(command, group)) {
    const FlagInfo& flag = FlagNamed(use.name);
    entries += Entry(FlagTerm(flag), FlagMeaning(flag, use), 24, TextWidth(terminal));
  }
  if (entries.empty()) return "";
  return absl::StrCat("\n", Styled(terminal, Style::kBold, Heading(group)), "\n", entries);
}

std::string Files(const Command& command, const Terminal& terminal) {
  std::string text;
  for (const OutputFile& file : command.files) {
    text += Entry(file.name, file.what, 24, TextWidth(terminal));
  }
  if (text.empty()) return "";
  return absl::StrCat("\n", Styled(terminal, Style::kBold, "Files that are written"), "\n", text);
}

std::string Examples(const Command& command, const Terminal& terminal) {
  std::string text;
  for (const Example& example : command.examples) {
    absl::StrAppend(&text, Wrapped(absl::StrCat("# ", example.what), kIndent, TextWidth(terminal)),
                    "\n  semantic_kiss ", example.arguments, "\n");
  }
  if (text.empty()) return "";
  return absl::StrCat("\n", Styled(terminal, Style::kBold, "Examples"), "\n", text);
}

std::string Usage(const Command& command) {
  return absl::StrCat("semantic_kiss ", ShortestUse(command), " [--flag=value ...]");
}

}  // namespace

std::string OverviewHelp(const std::vector<Command>& commands, const Terminal& terminal) {
  std::string help = absl::StrCat(Styled(terminal, Style::kBold, "semantic_kiss"),
                                  " COMMAND [--flag=value ...]\n\n",
                                  Wrapped(kProgramSummary, 0, TextWidth(terminal)), "\n\n",
                                  Styled(terminal, Style::kBold, "Commands"), "\n");
  for (const Command& command : commands) {
    help += Entry(command.name, command.summary, 14, TextWidth(terminal));
  }
  absl::StrAppend(
      &help, "\n",
      Wrapped("\"semantic_kiss COMMAND --help\" tells all about one; \"semantic_kiss --version\" "
              "prints the version.",
              0, TextWidth(terminal)),
      "\n\n", Wrapped(absl::StrCat("Exit codes: ", kExitCodes), 0, TextWidth(terminal)), "\n");
  return help;
}

std::string CommandHelp(const Command& command, const Terminal& terminal) {
  std::string help = absl::StrCat(Styled(terminal, Style::kBold, Usage(command)), "\n\n",
                                  Wrapped(command.description, 0, TextWidth(terminal)), "\n");
  for (const FlagGroup group : FlagGroups()) {
    help += FlagsOfGroup(command, group, terminal);
  }
  return absl::StrCat(help, Files(command, terminal), Examples(command, terminal));
}

}  // namespace semantic_kiss::cli
