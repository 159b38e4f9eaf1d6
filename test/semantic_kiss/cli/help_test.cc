// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "absl/strings/str_split.h"
#include "gflags/gflags.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Terminal PlainOfWidth(int width) { return Terminal{true, false, width}; }

TEST(FlagsTest, EveryFlagIsDescribedOnceAndKnownToGflags) {
  std::set<std::string> names;
  for (const FlagInfo& flag : Flags()) {
    EXPECT_TRUE(names.insert(flag.name).second) << flag.name;
    gflags::CommandLineFlagInfo definition;
    ASSERT_TRUE(gflags::GetCommandLineFlagInfo(flag.name.c_str(), &definition)) << flag.name;
    EXPECT_EQ(definition.type == "bool", flag.value == FlagValue::kNone) << flag.name;
    EXPECT_EQ(definition.description.back(), '.') << flag.name;
  }
}

TEST(CommandsTest, EveryCommandIsCompleteAndUsesFlagsThatExist) {
  std::set<std::string> used;
  for (const Command& command : Commands()) {
    EXPECT_FALSE(command.summary.empty()) << command.name;
    EXPECT_FALSE(command.description.empty()) << command.name;
    EXPECT_FALSE(command.examples.empty()) << command.name;
    EXPECT_NE(command.run, nullptr) << command.name;
    for (const FlagUse& use : command.flags) used.insert(FlagNamed(use.name).name);
  }
  for (const FlagInfo& flag : Flags()) EXPECT_TRUE(used.count(flag.name)) << flag.name;
}

TEST(HelpTest, OverviewListsEveryCommand) {
  const std::string help = OverviewHelp(Commands(), PlainOfWidth(80));
  for (const Command& command : Commands()) {
    EXPECT_THAT(help, HasSubstr("  " + command.name + " "));
    EXPECT_THAT(help, HasSubstr(command.summary));
  }
}

TEST(HelpTest, CommandHelpShowsGroupsDefaultsAndExamples) {
  const std::string help = CommandHelp(RunCommand(), PlainOfWidth(100));
  EXPECT_THAT(help, HasSubstr("semantic_kiss run --dataset=DIR"));
  EXPECT_THAT(help, HasSubstr("\nInput\n"));
  EXPECT_THAT(help, HasSubstr("[default: 00]"));
  EXPECT_THAT(help, HasSubstr("[default: all cores]"));
  EXPECT_THAT(help, HasSubstr("[required]"));
  EXPECT_THAT(help, HasSubstr("\nExamples\n"));
  EXPECT_THAT(help, Not(HasSubstr("--estimate=FILE"))) << "that is another command's";
}

// Examples are to be copied, so they are not broken; all else keeps within the terminal.
TEST(HelpTest, FitsFortyColumns) {
  for (const Command& command : Commands()) {
    for (absl::string_view line : absl::StrSplit(CommandHelp(command, PlainOfWidth(40)), '\n')) {
      if (line.substr(0, 2) == "  " && line.find("semantic_kiss ") != line.npos) continue;
      if (line.substr(0, 14) == "semantic_kiss ") continue;
      EXPECT_LE(line.size(), 40) << line;
    }
  }
}

TEST(HelpTest, ColoursOnlyWhereTheTerminalHasThem) {
  EXPECT_THAT(CommandHelp(RunCommand(), PlainOfWidth(80)), Not(HasSubstr("\033")));
  EXPECT_THAT(CommandHelp(RunCommand(), Terminal{true, true, 80}), HasSubstr("\033[1m"));
}

}  // namespace
}  // namespace semantic_kiss::cli
