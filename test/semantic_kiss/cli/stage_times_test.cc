// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/stage_times.h"

#include <gtest/gtest.h>

#include <numeric>

namespace semantic_kiss::cli {
namespace {

TEST(SummarizeTest, OfOneDurationIsThatDuration) {
  const StageSummary summary = Summarize({40.});
  EXPECT_DOUBLE_EQ(summary.median_ms, 40.);
  EXPECT_DOUBLE_EQ(summary.p95_ms, 40.);
  EXPECT_DOUBLE_EQ(summary.total_s, 0.04);
}

TEST(SummarizeTest, MedianOfEvenAndOddCounts) {
  EXPECT_DOUBLE_EQ(Summarize({3., 1., 2.}).median_ms, 2.);
  EXPECT_DOUBLE_EQ(Summarize({4., 1., 3., 2.}).median_ms, 2.5);
}

TEST(SummarizeTest, NinetyFiveOfAHundredAreAtMostP95) {
  for (const int size : {19, 20, 21, 100, 101}) {
    std::vector<double> durations_ms(size);
    std::iota(durations_ms.begin(), durations_ms.end(), 1.);
    const double p95_ms = Summarize(durations_ms).p95_ms;
    // Durations are 1..size, so p95_ms counts those that are at most that long.
    EXPECT_GE(p95_ms, 0.95 * size);
    EXPECT_LT(p95_ms - 1., 0.95 * size);
  }
}

TEST(SummarizeDeathTest, NeedsADuration) { EXPECT_DEATH(Summarize({}), ""); }

TEST(StageTimesTest, KeepsTheOrderOfFirstAppearance) {
  StageTimes times;
  EXPECT_TRUE(times.Summaries().empty());
  times.Add("reading", 0.002);
  times.Add("odometry", 0.020);
  times.Add("reading", 0.004);
  const auto summaries = times.Summaries();
  ASSERT_EQ(summaries.size(), 2);
  EXPECT_EQ(summaries[0].first, "reading");
  EXPECT_DOUBLE_EQ(summaries[0].second.median_ms, 3.);
  EXPECT_DOUBLE_EQ(summaries[0].second.total_s, 0.006);
  EXPECT_EQ(summaries[1].first, "odometry");
}

}  // namespace
}  // namespace semantic_kiss::cli
