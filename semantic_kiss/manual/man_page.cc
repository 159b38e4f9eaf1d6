// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/man_page.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "semantic_kiss/cli/flag_text.h"
#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::manual {
namespace {

using cli::Command;

// What is typed: every hyphen is a minus, else copying it from the page gives another character.
std::string Typed(absl::string_view text) {
  return absl::StrReplaceAll(RoffText(text), {{"\\-", "\\-"}, {"-", "\\-"}});
}

// Prose, in lines that are short enough for tools that read roff.
std::string Prose(absl::string_view text) {
  return absl::StrCat(RoffText(cli::Wrapped(text, 0, 76)), "\n");
}

std::string Paragraphs(absl::string_view text) {
  return absl::StrJoin(
      absl::StrSplit(text, "\n\n"), ".PP\n",
      [](std::string* out, absl::string_view paragraph) { *out += Prose(paragraph); });
}

std::string Entry(const std::string& term, const std::string& meaning) {
  return absl::StrCat(".TP\n.B ", Typed(term), "\n", Prose(meaning));
}

std::string FlagsOf(const Command& command) {
  std::string text;
  for (const cli::FlagGroup group : cli::FlagGroups()) {
    const std::vector<cli::FlagUse> uses = cli::UsesOfGroup(command, group);
    if (!uses.empty()) absl::StrAppend(&text, ".PP\n.I ", cli::Heading(group), "\n");
    for (const cli::FlagUse& use : uses) {
      const cli::FlagInfo& flag = cli::FlagNamed(use.name);
      absl::StrAppend(&text, Entry(cli::FlagTerm(flag), cli::FlagMeaning(flag, use)));
    }
  }
  return text;
}

std::string SectionOf(const Command& command) {
  std::string text =
      absl::StrCat(".SS ", command.name, "\n", Paragraphs(command.description), FlagsOf(command));
  if (!command.files.empty()) absl::StrAppend(&text, ".PP\n.I Files that are written\n");
  for (const cli::OutputFile& file : command.files) {
    absl::StrAppend(&text, Entry(file.name, file.what));
  }
  absl::StrAppend(&text, ".PP\n.I Examples\n");
  for (const cli::Example& example : command.examples) {
    absl::StrAppend(&text, ".PP\n", Prose(example.what + ":"), ".PP\n.nf\n.RS\n",
                    Typed(absl::StrCat("semantic_kiss ", example.arguments)), "\n.RE\n.fi\n");
  }
  return text;
}

}  // namespace

std::string RoffText(absl::string_view text) {
  std::string escaped = absl::StrReplaceAll(
      text, {{"\\", "\\e"}, {"--", "\\-\\-"}, {"\n.", "\n\\&."}, {"\n'", "\n\\&'"}});
  if (!escaped.empty() && (escaped[0] == '.' || escaped[0] == '\'')) escaped.insert(0, "\\&");
  return escaped;
}

std::string ManPage(const std::vector<Command>& commands, absl::string_view version) {
  std::string page = absl::StrCat(
      ".\\\" Generated from the declarations of commands and flags.\n"
      ".TH SEMANTIC_KISS 1 \"\" \"semantic_kiss ",
      version, "\" \"User Commands\"\n.SH NAME\nsemantic_kiss \\- semantic LiDAR SLAM\n",
      ".SH SYNOPSIS\n");
  for (const Command& command : commands) {
    absl::StrAppend(&page, ".B semantic_kiss ", Typed(cli::ShortestUse(command)),
                    "\n[\\-\\-flag=value ...]\n.br\n");
  }
  absl::StrAppend(
      &page, ".B semantic_kiss\n[\\-\\-help | \\-\\-version]\n", ".SH DESCRIPTION\n",
      Prose(cli::kProgramSummary), ".SH COMMANDS\n",
      Prose(
          "A flag may be written as --name=value or --name value; a flag without value is negated "
          "by --noname. --help tells the same as this page."));
  for (const Command& command : commands) absl::StrAppend(&page, SectionOf(command));
  absl::StrAppend(&page, ".SH EXIT STATUS\n", Prose(cli::kExitCodes), ".SH FILES\n",
                  Entry("share/semantic_kiss/configuration_files",
                        "Configurations that --config finds by name, label sets, and the defaults "
                        "of all options; beside the folder of the program."),
                  Entry("share/doc/semantic_kiss/options.md", "What every option means."));
  return page;
}

}  // namespace semantic_kiss::manual
