// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/deskew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace semantic_kiss::odometry {
namespace {

using cartographer::transform::Exp;
using cartographer::transform::Rigid3d;
using cartographer::transform::Twist;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Twist FastTurn() {
  Twist motion;
  motion << 2., 0.1, -0.05, 0.01, -0.02, 0.1;
  return motion;
}

TEST(DeskewTest, PointsMoveAsTheModelSays) {
  const std::vector<float> times = {-0.1f, -0.08f, -0.033f, 0.f};
  const auto sweep = SweepMotion::Create(times, FastTurn());
  ASSERT_TRUE(sweep.has_value());
  const Eigen::Vector3f far(60.f, -80.f, 5.f);
  for (const float time : times) {
    const double fraction = (time + 0.1f) / 0.1f;
    const Eigen::Vector3d expected = Exp((fraction - 1.) * FastTurn()) * far.cast<double>();
    EXPECT_LT((sweep->ToSweepEnd(far, time).cast<double>() - expected).norm(), 1e-4) << time;
  }
}

TEST(DeskewTest, AWallSeenWhileDrivingIsFlatAgain) {
  // The sensor passes a wall at y = 10 m; each point is taken from another place on the way.
  const Twist motion = FastTurn();
  const Rigid3d start_from_end = Exp(motion);
  std::vector<float> times;
  std::vector<Eigen::Vector3f> skewed, at_end;
  for (int i = 0; i <= 100; ++i) {
    const double fraction = i / 100.;
    const Eigen::Vector3d in_end(-20. + 0.4 * i, 10., 0.02 * i);
    // start_from_now = Exp(fraction * motion)
    const Rigid3d now_from_end = Exp(fraction * motion).inverse() * start_from_end;
    times.push_back(static_cast<float>(0.1 * fraction));
    skewed.push_back((now_from_end * in_end).cast<float>());
    at_end.push_back(in_end.cast<float>());
  }
  const auto sweep = SweepMotion::Create(times, motion);
  ASSERT_TRUE(sweep.has_value());
  for (size_t i = 0; i < times.size(); ++i) {
    EXPECT_LT((sweep->ToSweepEnd(skewed[i], times[i]) - at_end[i]).norm(), 1e-4) << i;
  }
  EXPECT_GT((skewed[0] - at_end[0]).norm(), 1.);
}

TEST(DeskewTest, NothingToUndoWithoutUsefulTimes) {
  EXPECT_FALSE(SweepMotion::Create({}, FastTurn()).has_value());
  EXPECT_FALSE(SweepMotion::Create({0.05f, 0.05f, 0.05f}, FastTurn()).has_value());
  EXPECT_FALSE(SweepMotion::Create({kNan, 0.05f, kNan}, FastTurn()).has_value());
  // Shorter than any sweep, and longer than can be computed with.
  EXPECT_FALSE(SweepMotion::Create({-1e-45f, 0.f, 0.f}, FastTurn()).has_value());
  EXPECT_FALSE(SweepMotion::Create({-3e38f, 3e38f}, FastTurn()).has_value());
}

TEST(DeskewTest, PointsWithoutATimeStay) {
  const auto sweep = SweepMotion::Create({-0.1f, kNan, 0.f}, FastTurn());
  ASSERT_TRUE(sweep.has_value());
  const Eigen::Vector3f point(10.f, 20.f, 1.f);
  EXPECT_EQ(sweep->ToSweepEnd(point, kNan), point);
  EXPECT_EQ(sweep->ToSweepEnd(point, std::numeric_limits<float>::infinity()), point);
}

TEST(DeskewTest, AStandingSensorChangesNothing) {
  const auto sweep = SweepMotion::Create({0.f, 0.1f}, Twist::Zero());
  ASSERT_TRUE(sweep.has_value());
  const Eigen::Vector3f point(10.f, 20.f, 1.f);
  EXPECT_LT((sweep->ToSweepEnd(point, 0.03f) - point).norm(), 1e-5);
}

}  // namespace
}  // namespace semantic_kiss::odometry
