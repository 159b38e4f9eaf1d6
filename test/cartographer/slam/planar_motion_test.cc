// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/planar_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cartographer::slam {
namespace {

using scan_matching::PlanarPose;

common::Time At(double seconds) { return common::FromUnixSeconds(seconds); }

TEST(PlanarMotionTest, StandsUntilTwoPosesAreKnown) {
  PlanarMotion motion;
  EXPECT_FALSE(motion.IsKnown());
  EXPECT_EQ(motion.Predict(At(1.)).translation, Eigen::Vector2d(0., 0.));
  motion.Observe(At(1.), {{3., 4.}, 0.5});
  EXPECT_FALSE(motion.IsKnown());
  EXPECT_EQ(motion.Predict(At(2.)).translation, Eigen::Vector2d(3., 4.));
  EXPECT_EQ(motion.Predict(At(2.)).yaw_rad, 0.5);
}

TEST(PlanarMotionTest, ACircleGoesOn) {
  // 1 m ahead and 0.1 rad to the left a second, by composition.
  PlanarMotion motion;
  PlanarPose pose;
  for (int i = 0; i < 80; ++i) {
    if (i >= 2) {
      const PlanarPose predicted = motion.Predict(At(i));
      EXPECT_LT((predicted.translation - pose.translation).norm(), 1e-9);
      EXPECT_NEAR(std::remainder(predicted.yaw_rad - pose.yaw_rad, 2. * M_PI), 0., 1e-9);
    }
    motion.Observe(At(i), pose);
    pose.translation += Eigen::Rotation2Dd(pose.yaw_rad) * Eigen::Vector2d(1., 0.);
    pose.yaw_rad = std::remainder(pose.yaw_rad + 0.1, 2. * M_PI);
  }
}

TEST(PlanarMotionTest, GoesBySecondsNotByScans) {
  PlanarMotion motion;
  motion.Observe(At(0.), {{0., 0.}, 0.});
  motion.Observe(At(0.1), {{1., 0.}, 0.});
  EXPECT_NEAR(motion.Predict(At(0.3)).translation.x(), 3., 1e-6);
}

}  // namespace
}  // namespace cartographer::slam
