// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace semantic_kiss::simulation {
namespace {

TEST(PathTest, StraightHasEvenPoints) {
  const auto path = RoundedPath({{{0., 0.}, 5.}, {{10., 0.}, 5.}});
  ASSERT_EQ(path.size(), 40u);
  for (size_t i = 0; i < path.size(); ++i) {
    EXPECT_NEAR(path[i].pose.position.x(), kPathStep_m * i, 1e-9);
    EXPECT_NEAR(path[i].pose.yaw, 0., 1e-9);
  }
}

TEST(PathTest, CornersAreRoundedWithTheirRadius) {
  const auto path = RoundedPath({{{0., 0.}, 0.}, {{50., 0.}, 10.}, {{50., 50.}, 0.}});
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const double step = (path[i + 1].pose.position - path[i].pose.position).norm();
    EXPECT_NEAR(step, kPathStep_m, 0.01) << i;
    EXPECT_LE(std::abs(path[i + 1].pose.yaw - path[i].pose.yaw), kPathStep_m / 10. + 1e-9) << i;
  }
  // The arc's centre is (40, 10).
  for (const PathPoint& point : path) {
    if (point.radius_m > 100.) continue;
    EXPECT_NEAR((point.pose.position - Eigen::Vector2d(40., 10.)).norm(), 10., 1e-6);
  }
  EXPECT_NEAR(path.back().pose.yaw, M_PI / 2., 1e-6);
}

TEST(PathTest, RightTurnsTurnRight) {
  const auto path = RoundedPath({{{0., 0.}, 0.}, {{50., 0.}, 10.}, {{50., -50.}, 0.}});
  EXPECT_NEAR(path.back().pose.yaw, -M_PI / 2., 1e-6);
  EXPECT_NEAR(path.back().pose.position.x(), 50., 1e-6);
}

TEST(PathTest, DrivesWithinItsLimits) {
  const SpeedLimits limits{12., 2., 1.5};
  const auto path =
      RoundedPath({{{0., 0.}, 0.}, {{80., 0.}, 8.}, {{80., 80.}, 8.}, {{0., 80.}, 0.}});
  constexpr double kRate_hz = 10.;
  const auto poses = DrivePath(path, limits, kRate_hz);
  double fastest = 0., slowest = 1e9, last = -1.;
  for (size_t i = 1; i < poses.size(); ++i) {
    const double speed = kRate_hz * (poses[i].position - poses[i - 1].position).norm();
    fastest = std::max(fastest, speed);
    slowest = std::min(slowest, speed);
    if (last >= 0.) {
      EXPECT_LE(std::abs(speed - last) * kRate_hz, 2. * 1.5) << i;
    }
    last = speed;
  }
  EXPECT_NEAR(fastest, 12., 0.1);
  EXPECT_NEAR(slowest, std::sqrt(2. * 8.), 0.2);
}

}  // namespace
}  // namespace semantic_kiss::simulation
