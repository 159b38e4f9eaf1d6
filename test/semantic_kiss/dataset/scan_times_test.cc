// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/scan_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/test_files.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::common::FromUnixSeconds;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ScanTimesTest : public ::testing::Test {
 protected:
  auto Read(const std::string& text) {
    WriteText(path_, text);
    return ReadScanTimes(path_);
  }
  std::string Error(const std::string& text) { return std::string(Read(text).status().message()); }

  const TemporaryDirectory directory_;
  const std::string path_ = directory_ / "times.txt";
};

TEST_F(ScanTimesTest, ReadsOneTimeALine) {
  EXPECT_THAT(
      Read("0.000000e+00\n1.037359e-01\n2.073381e-01\n").value(),
      ElementsAre(FromUnixSeconds(0.), FromUnixSeconds(0.1037359), FromUnixSeconds(0.2073381)));
}

TEST_F(ScanTimesTest, ToleratesWindowsLineEndsAndTrailingBlanks) {
  EXPECT_THAT(Read("0.5\r\n  0.6 \r\n\n \n").value(),
              ElementsAre(FromUnixSeconds(0.5), FromUnixSeconds(0.6)));
  EXPECT_THAT(Read("").value(), IsEmpty());
  EXPECT_THAT(Read("\n").value(), IsEmpty());
}

TEST_F(ScanTimesTest, TimesMustIncrease) {
  EXPECT_EQ(Error("0\n0.1\n0.1\n"),
            path_ +
                ":3: the time is 0.1, not later than that of the line before; times must "
                "increase, by 100 ns at least");
  EXPECT_EQ(Error("0.2\n0.1\n").find(path_ + ":2: the time is 0.1, not later"), 0);
  EXPECT_EQ(Error("0.1\n0.10000001\n").find(path_ + ":2: the time is 0.10000001, not"), 0);
}

TEST_F(ScanTimesTest, NamesTheLineThatIsNoTime) {
  EXPECT_EQ(Error("0\nzero\n"),
            path_ + ":2: \"zero\" is not a time; one number is needed, the seconds of the scan");
  EXPECT_EQ(Error("0\n\n1\n").find(path_ + ":2: \"\" is not a time"), 0);
  EXPECT_EQ(Error("0 1\n").find(path_ + ":1: \"0 1\" is not a time"), 0);
  EXPECT_EQ(Error(std::string("\0\x01", 2)).find(path_ + ":1: \"\\x00\\x01\" is not a time"), 0);
}

TEST_F(ScanTimesTest, RefusesOtherUnits) {
  EXPECT_EQ(Error("1403636579763555584\n"),
            path_ + ":1: the time is 1.40364e+18; seconds from 0 to 1e+10 are expected");
  for (const char* time : {"-1", "nan", "inf", "1e300"}) {
    EXPECT_EQ(Error(time).find(path_ + ":1: the time is "), 0) << time;
  }
}

TEST_F(ScanTimesTest, NotFoundIfMissing) {
  EXPECT_EQ(ReadScanTimes(path_).status().code(), absl::StatusCode::kNotFound);
}

}  // namespace
}  // namespace semantic_kiss::dataset
