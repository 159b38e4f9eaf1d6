// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/output_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace semantic_kiss::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OutputDirectoryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = ::testing::TempDir() + "/output_directory_XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_;
};

TEST_F(OutputDirectoryTest, MakesParentsAndRemovesThemIfNothingWasWritten) {
  const fs::path deep = root_ / "a/b/c";
  {
    const auto directory = OutputDirectory::Create(deep.string());
    ASSERT_TRUE(directory.ok()) << directory.status();
    EXPECT_TRUE(fs::is_directory(deep));
    EXPECT_TRUE(fs::is_empty(deep)) << "the trial file is gone";
  }
  EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(OutputDirectoryTest, KeepsWhatHasFiles) {
  {
    const auto directory = OutputDirectory::Create((root_ / "a/b/").string());
    ASSERT_TRUE(directory.ok()) << directory.status();
    std::ofstream(directory->FileNamed("run.json")) << "{}";
  }
  EXPECT_TRUE(fs::exists(root_ / "a/b/run.json"));
}

TEST_F(OutputDirectoryTest, KeepsDirectoriesThatWereThere) {
  fs::create_directory(root_ / "a");
  { ASSERT_TRUE(OutputDirectory::Create((root_ / "a").string()).ok()); }
  EXPECT_TRUE(fs::is_directory(root_ / "a"));
}

TEST_F(OutputDirectoryTest, ReportsWhyThereCanBeNone) {
  std::ofstream(root_ / "file") << "";
  for (const char* path : {"file", "file/below"}) {
    const auto directory = OutputDirectory::Create((root_ / path).string());
    ASSERT_FALSE(directory.ok()) << path;
    EXPECT_THAT(std::string(directory.status().message()), HasSubstr(path));
    EXPECT_THAT(std::string(directory.status().message()), HasSubstr("Not a directory"));
    EXPECT_THAT(std::string(directory.status().message()), HasSubstr("--output"));
  }
}

}  // namespace
}  // namespace semantic_kiss::cli
