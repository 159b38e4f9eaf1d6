// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/vehicle_frame.h"

#include <gtest/gtest.h>

#include "test/semantic_kiss/evaluation/drives.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

// Drives forward along `forward` of the body, turning a full circle about the body's `up`.
Poses Circle(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  const Rigid3d step(forward, Eigen::Quaterniond(Eigen::AngleAxisd(2. * M_PI / 60., up)));
  Poses poses(1);
  for (int i = 0; i < 60; ++i) poses.push_back(poses.back() * step);
  return poses;
}

TEST(VehicleFrameTest, IsToldByTheAxisOfDriving) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  EXPECT_EQ(GuessVehicleFrame(Circle(x, z)), VehicleFrame::kLidar);
  EXPECT_EQ(GuessVehicleFrame(Circle(z, -y)), VehicleFrame::kCamera);
  EXPECT_EQ(GuessVehicleFrame(Circle(-x, z)), VehicleFrame::kLidar);  // backwards
  EXPECT_EQ(GuessVehicleFrame(Circle(y, z)), std::nullopt);
  EXPECT_EQ(GuessVehicleFrame(Circle(x + z, y)), std::nullopt);
}

TEST(VehicleFrameTest, IsOpenWhereNothingIsDriven) {
  EXPECT_EQ(GuessVehicleFrame({}), std::nullopt);
  EXPECT_EQ(GuessVehicleFrame(Poses(1)), std::nullopt);
  EXPECT_EQ(GuessVehicleFrame(StraightDrive(10, 0.1)), std::nullopt);
  EXPECT_EQ(GuessVehicleFrame(StraightDrive(12, 0.1)), VehicleFrame::kLidar);
}

TEST(VehicleFrameTest, NamesAndUpwardAxes) {
  EXPECT_STREQ(NameOf(VehicleFrame::kCamera), "camera");
  EXPECT_STREQ(NameOf(VehicleFrame::kLidar), "lidar");
  EXPECT_EQ(UpAxis(VehicleFrame::kCamera), Eigen::Vector3d(0., -1., 0.));
  EXPECT_EQ(UpAxis(VehicleFrame::kLidar), Eigen::Vector3d(0., 0., 1.));
}

}  // namespace
}  // namespace semantic_kiss::evaluation
