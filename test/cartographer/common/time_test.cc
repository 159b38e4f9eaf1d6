// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/time.h"

#include <gtest/gtest.h>

namespace cartographer::common {
namespace {

TEST(TimeTest, CountsTicksOf100Nanoseconds) {
  EXPECT_EQ(FromSeconds(1.).count(), 10'000'000);
  EXPECT_EQ(FromSeconds(0.).count(), 0);
  EXPECT_EQ(FromSeconds(-2.5).count(), -25'000'000);
  EXPECT_EQ(ToSeconds(Duration{1}), 1e-7);
}

TEST(TimeTest, RoundsToTheNearestTick) {
  EXPECT_EQ(FromSeconds(1.4e-7).count(), 1);
  EXPECT_EQ(FromSeconds(1.6e-7).count(), 2);
  EXPECT_EQ(FromSeconds(-1.6e-7).count(), -2);
  // 0.1 s is no binary fraction; the tick is the right one all the same.
  for (int i = 0; i < 100'000; ++i) {
    ASSERT_EQ(FromSeconds(i * 0.1).count(), int64_t{1'000'000} * i) << i;
  }
}

TEST(TimeTest, SecondsSurviveTheRoundTrip) {
  for (const int64_t ticks : {int64_t{0}, int64_t{1}, int64_t{-1}, int64_t{123'456'789'012}}) {
    EXPECT_EQ(FromSeconds(ToSeconds(Duration{ticks})).count(), ticks);
  }
}

TEST(TimeTest, StartsInTheYearOne) {
  // 719,162 days from 0001-01-01 to 1970-01-01 in the Gregorian calendar.
  EXPECT_EQ(ToUniversal(kUnixEpoch), int64_t{719'162} * 24 * 3600 * 10'000'000);
  EXPECT_EQ(FromUnixSeconds(0.), kUnixEpoch);
  EXPECT_EQ(ToUnixSeconds(kUnixEpoch), 0.);
  EXPECT_EQ(ToUniversal(FromUnixSeconds(1.5)), ToUniversal(kUnixEpoch) + 15'000'000);
  EXPECT_EQ(ToUnixSeconds(FromUnixSeconds(-3600.)), -3600.);
}

TEST(TimeTest, UniversalTicksSurviveTheRoundTrip) {
  for (const int64_t ticks : {int64_t{0}, int64_t{635'727'208'200'176'089}, int64_t{-5}}) {
    EXPECT_EQ(ToUniversal(FromUniversal(ticks)), ticks);
  }
}

}  // namespace
}  // namespace cartographer::common
