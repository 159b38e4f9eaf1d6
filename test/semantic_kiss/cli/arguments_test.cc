// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/arguments.h"

#include <gflags/gflags.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ArgumentsTest : public ::testing::Test {
 protected:
  ArgumentsTest() : commands_(2) {
    commands_[0].name = "run";
    commands_[0].flags = {{"dataset", true}, {"num_scans"}, {"quiet"}};
    commands_[1].name = "render";
    commands_[1].flags = {{"resolution"}, {"hide"}};
  }

  absl::StatusOr<Invocation> Parse(const std::vector<std::string>& arguments) {
    return ParseArguments(commands_, arguments);
  }

  std::string ErrorOf(const std::vector<std::string>& arguments) {
    const absl::StatusOr<Invocation> invocation = Parse(arguments);
    EXPECT_FALSE(invocation.ok());
    EXPECT_EQ(invocation.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(invocation.status().message()), Not(HasSubstr("\n")));
    return std::string(invocation.status().message());
  }

  std::vector<Command> commands_;
  gflags::FlagSaver saver_;
};

TEST_F(ArgumentsTest, SetsFlagsInEveryForm) {
  const auto invocation = Parse({"run", "--dataset=/data", "--num_scans", "7", "--quiet"});
  ASSERT_TRUE(invocation.ok()) << invocation.status();
  EXPECT_EQ(invocation->kind, Invocation::Kind::kRun);
  EXPECT_EQ(invocation->command, &commands_[0]);
  EXPECT_EQ(FLAGS_dataset, "/data");
  EXPECT_EQ(FLAGS_num_scans, 7);
  EXPECT_TRUE(FLAGS_quiet);
}

TEST_F(ArgumentsTest, UnderstandsNegatedBooleans) {
  FLAGS_quiet = true;
  ASSERT_TRUE(Parse({"run", "--dataset=/data", "--noquiet"}).ok());
  EXPECT_FALSE(FLAGS_quiet);
  ASSERT_TRUE(Parse({"run", "--dataset=/data", "--quiet=true"}).ok());
  EXPECT_TRUE(FLAGS_quiet);
}

TEST_F(ArgumentsTest, TheLastOfRepeatedFlagsHolds) {
  ASSERT_TRUE(Parse({"run", "--dataset=a", "--dataset=b"}).ok());
  EXPECT_EQ(FLAGS_dataset, "b");
}

TEST_F(ArgumentsTest, ValuesMayHoldEqualsSignsAndBlanks) {
  ASSERT_TRUE(Parse({"run", "--dataset=a=b c"}).ok());
  EXPECT_EQ(FLAGS_dataset, "a=b c");
}

TEST_F(ArgumentsTest, HelpAndVersionNeedNothingElse) {
  EXPECT_EQ(Parse({"--version"})->kind, Invocation::Kind::kVersion);
  for (const char* argument : {"--help", "-h", "help"}) {
    EXPECT_EQ(Parse({argument})->kind, Invocation::Kind::kHelp) << argument;
    EXPECT_EQ(Parse({argument})->command, nullptr) << argument;
  }
  EXPECT_EQ(Parse({"run", "--help"})->command, &commands_[0]);
  EXPECT_EQ(Parse({"run", "--nonsense", "-h"})->kind, Invocation::Kind::kHelp);
  EXPECT_EQ(Parse({"help", "render"})->command, &commands_[1]);
}

TEST_F(ArgumentsTest, NamesTheNearestCommandAndFlag) {
  EXPECT_THAT(ErrorOf({"rnder"}), AllOf(HasSubstr("rnder"), HasSubstr("render")));
  EXPECT_THAT(ErrorOf({"help", "rnu"}), HasSubstr("run"));
  EXPECT_THAT(ErrorOf({"run", "--datset=x"}), AllOf(HasSubstr("--datset"), HasSubstr("dataset")));
  EXPECT_THAT(ErrorOf({"run", "--noquite"}), HasSubstr("quiet"));
}

TEST_F(ArgumentsTest, KeepsFlagsOfOtherCommandsOut) {
  EXPECT_THAT(ErrorOf({"render", "--dataset=x"}), HasSubstr("no flag --dataset"));
  EXPECT_THAT(ErrorOf({"render", "--logtostderr"}), HasSubstr("no flag --logtostderr"));
}

TEST_F(ArgumentsTest, ReportsMissingParts) {
  EXPECT_THAT(ErrorOf({}), HasSubstr("no command"));
  EXPECT_THAT(ErrorOf({"run"}), HasSubstr("needs --dataset=DIR"));
  EXPECT_THAT(ErrorOf({"run", "--dataset="}), HasSubstr("needs --dataset=DIR"));
  EXPECT_THAT(ErrorOf({"run", "--dataset"}), HasSubstr("--dataset needs a value"));
  EXPECT_THAT(ErrorOf({"run", "--dataset", "--quiet"}), HasSubstr("--dataset needs a value"));
}

TEST_F(ArgumentsTest, ReportsBadValues) {
  EXPECT_THAT(ErrorOf({"run", "--num_scans=many"}), HasSubstr("--num_scans=many"));
  EXPECT_THAT(ErrorOf({"run", "--num_scans=-1"}), HasSubstr("at least 0"));
  EXPECT_THAT(ErrorOf({"run", "--num_scans=99999999999"}), HasSubstr("99999999999"));
  EXPECT_THAT(ErrorOf({"run", "--quiet=perhaps"}), HasSubstr("--quiet=perhaps"));
  EXPECT_THAT(ErrorOf({"render", "--resolution=nan"}), HasSubstr("--resolution=nan"));
}

TEST_F(ArgumentsTest, ReportsWhatIsNoFlag) {
  EXPECT_THAT(ErrorOf({"run", "data"}), HasSubstr("`data` is not a flag"));
  EXPECT_THAT(ErrorOf({"run", "-dataset=x"}), HasSubstr("write --name=value"));
  EXPECT_THAT(ErrorOf({"--dataset=x", "run"}), HasSubstr("the command comes first"));
}

}  // namespace
}  // namespace semantic_kiss::cli
