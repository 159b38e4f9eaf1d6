// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::cli {
namespace {

TEST(RunTextTest, TellsOfScans) {
  RunResult result;
  result.drive.num_scans = result.scans_available = 7;
  EXPECT_EQ(ScansText(result), "7");
  result.scans_available = 12;
  EXPECT_EQ(ScansText(result), "7 of 12 (stopped)");
}

TEST(RunTextTest, ListsCounts) {
  DriveRecord drive;
  EXPECT_EQ(OutcomesText(drive), "");
  drive.outcomes = {{"converged", 9}, {"first", 1}};
  EXPECT_EQ(OutcomesText(drive), "9 converged, 1 first");
  EXPECT_EQ(UnknownLabelsText({}), "");
  EXPECT_EQ(UnknownLabelsText({{7, 3}, {9, 1}}), "id 7: 3 points, id 9: 1 points");
}

TEST(RunTextTest, FiguresMayBeMissing) {
  EXPECT_EQ(FigureText(1.2345, 2, "m"), "1.23 m");
  EXPECT_EQ(FigureText(1.2345, 0, ""), "1");
  EXPECT_EQ(FigureText(std::nullopt, 2, "m"), "-");
}

TEST(RunTextTest, NoTimeIsNoSpeed) {
  DriveRecord drive;
  drive.num_scans = 10;
  EXPECT_EQ(ScansPerSecond(drive), 0.);
  drive.elapsed_s = 2.;
  EXPECT_EQ(ScansPerSecond(drive), 5.);
}

}  // namespace
}  // namespace semantic_kiss::cli
