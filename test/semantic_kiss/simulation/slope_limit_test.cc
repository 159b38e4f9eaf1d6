// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/slope_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace semantic_kiss::simulation {
namespace {

// A straight drive with a pose each metre.
std::vector<PlanarPose> Straight(int size) {
  std::vector<PlanarPose> poses(size);
  for (int i = 0; i < size; ++i) poses[i].position.x() = i;
  return poses;
}

std::vector<double> Heights(int size, const std::function<double(int)>& height_m) {
  std::vector<double> heights_m(size);
  for (int i = 0; i < size; ++i) heights_m[i] = height_m(i);
  return heights_m;
}

TEST(SlopeLimitTest, RoadsThatAreNotTooSteepStayAsTheyAreBitForBit) {
  const auto heights_m = Heights(203, [](int i) { return 3. * std::sin(0.04 * i) + 0.01 * i; });
  EXPECT_EQ(LimitSlopes(Straight(203), heights_m, 0.15), heights_m);
  EXPECT_TRUE(LimitSlopes({}, {}, 0.15).empty());
  EXPECT_EQ(LimitSlopes(Straight(1), {5.}, 0.15), std::vector<double>{5.});
}

TEST(SlopeLimitTest, AJumpBecomesARampAndWhatFollowsKeepsItsShape) {
  const auto heights_m = Heights(101, [](int i) { return (i > 43 ? 9. : 0.) + 0.05 * i; });
  const auto limited_m = LimitSlopes(Straight(101), heights_m, 0.15);
  for (int i = 0; i <= 40; ++i) EXPECT_EQ(limited_m[i], heights_m[i]) << i;
  EXPECT_NEAR(limited_m[50] - limited_m[40], 1.5, 1e-9);
  for (int i = 50; i < 100; ++i) EXPECT_NEAR(limited_m[i + 1] - limited_m[i], 0.05, 1e-9) << i;
}

TEST(SlopeLimitTest, FallsAreLimitedLikeRises) {
  const auto up = LimitSlopes(Straight(40), Heights(40, [](int i) { return 0.9 * i; }), 0.15);
  const auto down = LimitSlopes(Straight(40), Heights(40, [](int i) { return -0.9 * i; }), 0.15);
  for (int i = 0; i < 40; ++i) {
    EXPECT_NEAR(up[i], 0.15 * i, 1e-9) << i;
    EXPECT_NEAR(down[i], -up[i], 1e-9) << i;
  }
}

TEST(SlopeLimitTest, ACarThatStandsIsNotLifted) {
  const auto lifted = Heights(30, [](int i) { return 0.2 * i; });
  const auto limited_m = LimitSlopes(std::vector<PlanarPose>(30), lifted, 0.15);
  EXPECT_EQ(*std::max_element(limited_m.begin(), limited_m.end()), 0.);
}

}  // namespace
}  // namespace semantic_kiss::simulation
