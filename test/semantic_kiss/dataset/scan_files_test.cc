// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/scan_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/test_files.h"

namespace semantic_kiss::dataset {
namespace {

using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ScanFilesTest : public ::testing::Test {
 protected:
  void Add(const std::vector<std::string>& names) {
    for (const std::string& name : names) WriteText(directory_ / name, "");
  }
  std::vector<std::string> Stems(const ScanRange& range) {
    std::vector<std::string> stems;
    const std::vector<ScanFile> files = ListScanFiles(directory_.path(), range).value();
    for (const ScanFile& file : files) {
      EXPECT_EQ(file.number, std::stoi(file.stem));
      stems.push_back(file.stem);
    }
    return stems;
  }
  std::string Error(const ScanRange& range) {
    return std::string(ListScanFiles(directory_.path(), range).status().message());
  }

  const TemporaryDirectory directory_;
};

TEST_F(ScanFilesTest, ListsNumbersInOrderAndIgnoresTheRest) {
  Add({"000010.bin", "000009.bin", "000011.bin", "._000009.bin", "9.txt", "readme.bin", ".bin",
       "000012.bin.part"});
  EXPECT_THAT(Stems({}), ElementsAre("000009", "000010", "000011"));
}

TEST_F(ScanFilesTest, ANumberThatIsTooLargeIsAnError) {
  Add({"0.bin", "3000000000.bin"});
  EXPECT_EQ(Error({}),
            directory_.path() + ": 3000000000.bin: the number is too large; rename the scans");
}

TEST_F(ScanFilesTest, TakesAStretch) {
  Add({"0.bin", "1.bin", "2.bin", "3.bin"});
  EXPECT_THAT(Stems({1, 2}), ElementsAre("1", "2"));
  EXPECT_THAT(Stems({2, {}}), ElementsAre("2", "3"));
  EXPECT_THAT(Stems({{}, 1}), ElementsAre("0"));
  EXPECT_THAT(Stems({3, 100}), ElementsAre("3"));
}

TEST_F(ScanFilesTest, AGapIsAnErrorOnlyWhereItIsCrossed) {
  Add({"0.bin", "1.bin", "3.bin", "4.bin"});
  EXPECT_EQ(Error({}), directory_.path() +
                           ": scan 2 is missing between 1.bin and 3.bin; supply it, or run the "
                           "stretches before and after it alone");
  EXPECT_THAT(Stems({{}, 2}), ElementsAre("0", "1"));
  EXPECT_THAT(Stems({3, {}}), ElementsAre("3", "4"));
}

TEST_F(ScanFilesTest, ANumberMustNotComeTwice) {
  Add({"000000.bin", "000001.bin", "1.bin"});
  EXPECT_EQ(Error({}),
            directory_.path() + ": 000001.bin and 1.bin have the same number; remove one");
}

TEST_F(ScanFilesTest, SaysWhichScansThereAre) {
  Add({"5.bin", "6.bin"});
  EXPECT_EQ(Error({7, {}}), directory_.path() + ": has the scans 5 to 6, not 7");
  EXPECT_EQ(Error({4, 2}), directory_.path() + ": has the scans 5 to 6, not 2 from 4");
  EXPECT_EQ(Error({5, 0}), directory_.path() + ": has the scans 5 to 6, not 0 from 5");
  EXPECT_EQ(Error({-1, {}}), directory_.path() + ": has the scans 5 to 6, not -1");
}

TEST_F(ScanFilesTest, WithoutScansSaysHowTheyAreCalled) {
  Add({"scan.pcd"});
  EXPECT_EQ(Error({}),
            directory_.path() + ": has no scans; they are called 000000.bin, 000001.bin, ...");
}

TEST_F(ScanFilesTest, ADirectoryThatCannotBeListedIsNamed) {
  const absl::Status status = ListScanFiles(directory_ / "missing", {}).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr((directory_ / "missing") + ": cannot be listed"));
}

}  // namespace
}  // namespace semantic_kiss::dataset
