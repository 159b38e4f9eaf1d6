// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/arguments.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/strip.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/status.h"
#include "gflags/gflags.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::common::NearestName;

absl::Status UsageError(const std::string& problem, const Command& command) {
  return absl::InvalidArgumentError(
      absl::StrCat(problem, " (see \"semantic_kiss ", command.name, " --help\")"));
}

gflags::CommandLineFlagInfo DefinitionOf(const std::string& flag) {
  return gflags::GetCommandLineFlagInfoOrDie(flag.c_str());
}

absl::StatusOr<const Command*> FindCommand(const std::vector<Command>& commands,
                                           const std::string& name) {
  std::vector<std::string> names;
  for (const Command& command : commands) {
    if (command.name == name) return &command;
    names.push_back(command.name);
  }
  return absl::InvalidArgumentError(absl::StrCat("there is no command `", name, "`; did you mean `",
                                                 NearestName(name, names),
                                                 "`? (see \"semantic_kiss --help\")"));
}

// An argument taken apart: --name, --name=value or --noname of a boolean flag.
struct FlagArgument {
  std::string name;
  std::optional<std::string> value;
};

bool Takes(const Command& command, const std::string& flag) {
  return std::any_of(command.flags.begin(), command.flags.end(),
                     [&](const FlagUse& use) { return use.name == flag; });
}

bool IsBoolean(const std::string& flag) { return DefinitionOf(flag).type == "bool"; }

absl::StatusOr<FlagArgument> SplitArgument(const Command& command, absl::string_view argument) {
  if (!absl::ConsumePrefix(&argument, "--")) {
    return UsageError(absl::StrCat("`", argument, "` is not a flag; write --name=value"), command);
  }
  FlagArgument flag;
  const size_t equals = argument.find('=');
  flag.name = std::string(argument.substr(0, equals));
  if (equals != absl::string_view::npos) flag.value = std::string(argument.substr(equals + 1));
  if (Takes(command, flag.name)) return flag;

  absl::string_view positive = flag.name;
  if (!flag.value.has_value() && absl::ConsumePrefix(&positive, "no") &&
      Takes(command, std::string(positive)) && IsBoolean(std::string(positive))) {
    return FlagArgument{std::string(positive), "false"};
  }
  std::vector<std::string> names;
  for (const FlagUse& use : command.flags) names.push_back(use.name);
  return UsageError(absl::StrCat("`", command.name, "` has no flag --", flag.name,
                                 "; did you mean --", NearestName(flag.name, names), "?"),
                    command);
}

absl::Status CheckRange(const Command& command, const FlagInfo& info, const std::string& value) {
  double number;
  if (info.value != FlagValue::kNumber) return absl::OkStatus();
  if (absl::SimpleAtod(value, &number) && number >= info.at_least && number <= info.at_most) {
    return absl::OkStatus();
  }
  std::vector<std::string> bounds;
  if (info.at_least > std::numeric_limits<double>::lowest()) {
    bounds.push_back(absl::StrCat("at least ", info.at_least));
  }
  if (info.at_most < std::numeric_limits<double>::max()) {
    bounds.push_back(absl::StrCat("at most ", info.at_most));
  }
  if (bounds.empty()) bounds.push_back("finite");
  return UsageError(absl::StrCat("--", info.name, "=", value, " is out of range; it must be ",
                                 absl::StrJoin(bounds, " and ")),
                    command);
}

absl::Status SetFlag(const Command& command, const std::string& name, const std::string& value) {
  if (gflags::SetCommandLineOption(name.c_str(), value.c_str()).empty()) {
    return UsageError(
        absl::StrCat("--", name, "=", value, " is not of type ", DefinitionOf(name).type), command);
  }
  return CheckRange(command, FlagNamed(name), value);
}

absl::Status CheckRequired(const Command& command) {
  for (const FlagUse& use : command.flags) {
    if (!use.required || !DefinitionOf(use.name).current_value.empty()) continue;
    return UsageError(absl::StrCat("`", command.name, "` needs --", use.name, "=",
                                   FlagNamed(use.name).value_name),
                      command);
  }
  return absl::OkStatus();
}

absl::Status ParseFlags(const Command& command, const std::vector<std::string>& arguments) {
  for (size_t i = 1; i < arguments.size(); ++i) {
    ASSIGN_OR_RETURN(FlagArgument flag, SplitArgument(command, arguments[i]));
    if (!flag.value.has_value() && IsBoolean(flag.name)) flag.value = "true";
    const FlagInfo& info = FlagNamed(flag.name);
    if (!flag.value.has_value() && !info.bare_value.empty()) flag.value = info.bare_value;
    if (!flag.value.has_value()) {
      if (i + 1 == arguments.size() || absl::StartsWith(arguments[i + 1], "--")) {
        return UsageError(
            absl::StrCat("--", flag.name, " needs a value, --", flag.name, "=", info.value_name),
            command);
      }
      flag.value = arguments[++i];
    }
    RETURN_IF_ERROR(SetFlag(command, flag.name, *flag.value));
  }
  return CheckRequired(command);
}

bool AsksForHelp(const std::string& argument) { return argument == "--help" || argument == "-h"; }

}  // namespace

absl::StatusOr<Invocation> ParseArguments(const std::vector<Command>& commands,
                                          const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    return absl::InvalidArgumentError("no command is given; \"semantic_kiss --help\" lists all");
  }
  const std::string& first = arguments[0];
  if (first == "--version") return Invocation{Invocation::Kind::kVersion};
  if (AsksForHelp(first) || (first == "help" && arguments.size() == 1)) {
    return Invocation{Invocation::Kind::kHelp};
  }
  if (absl::StartsWith(first, "-")) {
    return absl::InvalidArgumentError(absl::StrCat("the command comes first, not `", first,
                                                   "`; \"semantic_kiss --help\" lists all"));
  }
  ASSIGN_OR_RETURN(const Command* command,
                   FindCommand(commands, first == "help" ? arguments[1] : first));
  if (first == "help" || std::any_of(arguments.begin(), arguments.end(), AsksForHelp)) {
    return Invocation{Invocation::Kind::kHelp, command};
  }
  RETURN_IF_ERROR(ParseFlags(*command, arguments));
  return Invocation{Invocation::Kind::kRun, command};
}

}  // namespace semantic_kiss::cli
