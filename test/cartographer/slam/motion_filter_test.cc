// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/motion_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cartographer::slam {
namespace {

using transform::Rigid3d;

MotionFilter Filter() {
  proto::MotionFilterOptions options;
  options.set_max_time_s(5.);
  options.set_max_distance_m(0.5);
  options.set_max_angle_deg(2.);
  return MotionFilter(options);
}

common::Time At(double seconds) { return common::FromUnixSeconds(seconds); }

Rigid3d Turned(double angle_deg) {
  return Rigid3d::Rotation(
      Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * M_PI / 180., Eigen::Vector3d::UnitY())));
}

TEST(MotionFilterTest, AStandingCarGivesOneNodeAndThenOneNowAndThen) {
  MotionFilter filter = Filter();
  EXPECT_TRUE(filter.Admit(At(0.), Rigid3d()));
  EXPECT_FALSE(filter.Admit(At(0.1), Rigid3d()));
  EXPECT_FALSE(filter.Admit(At(5.), Rigid3d()));
  EXPECT_TRUE(filter.Admit(At(5.1), Rigid3d()));
  EXPECT_FALSE(filter.Admit(At(5.2), Rigid3d()));
}

TEST(MotionFilterTest, DistanceCountsFromTheLastNode) {
  MotionFilter filter = Filter();
  EXPECT_TRUE(filter.Admit(At(0.), Rigid3d()));
  EXPECT_FALSE(filter.Admit(At(0.1), Rigid3d::Translation({0.4, 0., 0.})));
  EXPECT_TRUE(filter.Admit(At(0.2), Rigid3d::Translation({0.6, 0., 0.})));
  EXPECT_FALSE(filter.Admit(At(0.3), Rigid3d::Translation({1., 0., 0.})));
}

TEST(MotionFilterTest, TurningCounts) {
  MotionFilter filter = Filter();
  EXPECT_TRUE(filter.Admit(At(0.), Rigid3d()));
  EXPECT_FALSE(filter.Admit(At(0.1), Turned(1.9)));
  EXPECT_TRUE(filter.Admit(At(0.2), Turned(2.1)));
}

}  // namespace
}  // namespace cartographer::slam
