// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/final_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/semantic_kiss/evaluation/drives.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

Eigen::Quaterniond Turn(double angle_deg, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * M_PI / 180., axis));
}

TEST(FinalErrorTest, SplitsDriftInTheLidarFrame) {
  const Rigid3d truth({10., 0., 0.}, Turn(30., Eigen::Vector3d::UnitZ()));
  const Rigid3d estimate({13., 4., 12.}, Turn(35., Eigen::Vector3d::UnitZ()));
  const DriftError error =
      ComputeDriftError({Rigid3d(), truth}, {Rigid3d(), estimate}, VehicleFrame::kLidar);
  EXPECT_NEAR(error.position_error_m, 13., 1e-12);
  EXPECT_NEAR(error.horizontal_error_m, 5., 1e-12);
  EXPECT_NEAR(error.height_error_m, 12., 1e-12);
  EXPECT_NEAR(error.rotation_error_deg, 5., 1e-9);
  EXPECT_NEAR(error.heading_error_deg, 5., 1e-9);
}

TEST(FinalErrorTest, SplitsDriftInTheCameraFrame) {
  // y points down: a larger y is too low, a turn about -y is to the left.
  const Rigid3d truth({0., 0., 10.}, Eigen::Quaterniond::Identity());
  const Rigid3d estimate({3., 12., 14.}, Turn(7., -Eigen::Vector3d::UnitY()));
  const DriftError error =
      ComputeDriftError({Rigid3d(), truth}, {Rigid3d(), estimate}, VehicleFrame::kCamera);
  EXPECT_NEAR(error.horizontal_error_m, 5., 1e-12);
  EXPECT_NEAR(error.height_error_m, -12., 1e-12);
  EXPECT_NEAR(error.heading_error_deg, 7., 1e-9);
}

TEST(FinalErrorTest, TiltIsNoHeading) {
  const Rigid3d estimate = Rigid3d::Rotation(Turn(8., Eigen::Vector3d::UnitX()));
  const DriftError error =
      ComputeDriftError({Rigid3d(), Rigid3d()}, {Rigid3d(), estimate}, VehicleFrame::kLidar);
  EXPECT_NEAR(error.rotation_error_deg, 8., 1e-9);
  EXPECT_NEAR(error.heading_error_deg, 0., 1e-9);
}

TEST(FinalErrorTest, SignOfTheQuaternionDoesNotMatter) {
  const Eigen::Quaterniond turn = Turn(-20., Eigen::Vector3d::UnitZ());
  const Rigid3d negated(Eigen::Vector3d::Zero(), Eigen::Quaterniond(-turn.coeffs()));
  const DriftError error =
      ComputeDriftError({Rigid3d(), Rigid3d()}, {Rigid3d(), negated}, VehicleFrame::kLidar);
  EXPECT_NEAR(error.heading_error_deg, -20., 1e-9);
}

TEST(FinalErrorTest, OfWholeTrajectories) {
  std::mt19937 random(7);
  const Poses truth = RandomDrive(50, &random);
  const Poses estimate = WithDrift(truth, &random);
  const DriftError error = ComputeFinalError(truth, estimate, VehicleFrame::kLidar);
  // By another way: both ends in the frame of the first pose, which the two share.
  const Rigid3d end_from_end = estimate.back().inverse() * truth.back();
  EXPECT_GT(error.position_error_m, 1e-3);
  EXPECT_NEAR(error.position_error_m, end_from_end.translation().norm(), 1e-10);
  EXPECT_NEAR(error.rotation_error_deg,
              cartographer::transform::RotationAngle(end_from_end) * 180. / M_PI, 1e-9);
  const DriftError moved =
      ComputeFinalError(Moved(RandomMotion(&random, 9., 2.), truth),
                        Moved(RandomMotion(&random, 9., 2.), estimate), VehicleFrame::kLidar);
  EXPECT_NEAR(moved.height_error_m, error.height_error_m, 1e-10);
  EXPECT_NEAR(moved.heading_error_deg, error.heading_error_deg, 1e-9);
}

TEST(FinalErrorTest, OnePoseHasNone) {
  const DriftError error = ComputeFinalError(Poses(1), Poses(1), VehicleFrame::kCamera);
  EXPECT_EQ(error.position_error_m, 0.);
  EXPECT_EQ(error.rotation_error_deg, 0.);
  EXPECT_DEATH(ComputeFinalError({}, {}, VehicleFrame::kCamera), "empty");
  EXPECT_DEATH(ComputeFinalError(Poses(1), Poses(2), VehicleFrame::kCamera), "size");
}

}  // namespace
}  // namespace semantic_kiss::evaluation
