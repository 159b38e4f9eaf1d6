// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/flag_text.h"

#include "absl/strings/str_cat.h"
#include "gflags/gflags.h"

namespace semantic_kiss::cli {

const char kProgramSummary[] =
    "LiDAR SLAM that knows what it sees: labeled scans in, a trajectory and a semantic map out.";

const char kExitCodes[] =
    "0 done; 1 the input is bad or the run failed, one line says why; 2 the command line is wrong; "
    "130 or 143 stopped by Ctrl-C or SIGTERM.";

std::vector<FlagGroup> FlagGroups() {
  return {FlagGroup::kInput, FlagGroup::kSelection, FlagGroup::kOutput, FlagGroup::kExecution};
}

const char* Heading(FlagGroup group) {
  switch (group) {
    case FlagGroup::kInput:
      return "Input";
    case FlagGroup::kSelection:
      return "Selection";
    case FlagGroup::kOutput:
      return "Output";
    case FlagGroup::kExecution:
      return "Execution";
  }
  return "";
}

std::string FlagTerm(const FlagInfo& flag) {
  if (!flag.bare_value.empty()) return absl::StrCat("--", flag.name, "[=", flag.value_name, "]");
  return flag.value_name.empty() ? absl::StrCat("--", flag.name)
                                 : absl::StrCat("--", flag.name, "=", flag.value_name);
}

std::string FlagMeaning(const FlagInfo& flag, const FlagUse& use) {
  const auto definition = gflags::GetCommandLineFlagInfoOrDie(flag.name.c_str());
  std::string fallback = flag.default_text.empty() ? definition.default_value : flag.default_text;
  if (definition.type == "bool") fallback.clear();
  if (!use.default_text.empty()) fallback = use.default_text;
  if (use.required) return absl::StrCat(definition.description, " [required]");
  if (fallback.empty()) return definition.description;
  return absl::StrCat(definition.description, " [default: ", fallback, "]");
}

std::vector<FlagUse> UsesOfGroup(const Command& command, FlagGroup group) {
  std::vector<FlagUse> uses;
  for (const FlagInfo& flag : Flags()) {
    if (flag.group != group) continue;
    for (const FlagUse& use : command.flags) {
      if (use.name == flag.name) uses.push_back(use);
    }
  }
  return uses;
}

std::string ShortestUse(const Command& command) {
  std::string text = command.name;
  for (const FlagUse& use : command.flags) {
    if (use.required) absl::StrAppend(&text, " ", FlagTerm(FlagNamed(use.name)));
  }
  return text;
}

}  // namespace semantic_kiss::cli
