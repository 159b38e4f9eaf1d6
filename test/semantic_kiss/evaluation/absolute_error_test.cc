// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/absolute_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/semantic_kiss/evaluation/drives.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

Poses PosesAt(const std::vector<Eigen::Vector3d>& positions) {
  Poses poses;
  for (const Eigen::Vector3d& position : positions) poses.push_back(Rigid3d::Translation(position));
  return poses;
}

// Standard deviation of 0, 1, ..., n - 1.
double SpreadOfIndices(int n) { return std::sqrt((n * n - 1.) / 12.); }

TEST(AbsoluteErrorTest, AbsentUnderThreePoses) {
  for (const int n : {0, 1, 2}) {
    EXPECT_FALSE(ComputeAbsoluteError3d(StraightDrive(n, 1.), StraightDrive(n, 2.)));
    EXPECT_FALSE(
        ComputeAbsoluteError2d(StraightDrive(n, 1.), StraightDrive(n, 2.), VehicleFrame::kLidar));
  }
  EXPECT_TRUE(ComputeAbsoluteError3d(StraightDrive(3, 1.), StraightDrive(3, 2.)));
}

TEST(AbsoluteErrorTest, IdenticalTrajectoriesHaveNone) {
  std::mt19937 random(1);
  const Poses drive = RandomDrive(100, &random);
  EXPECT_LT(ComputeAbsoluteError3d(drive, drive)->rmse_m, 1e-12);
  EXPECT_LT(ComputeAbsoluteError2d(drive, drive, VehicleFrame::kCamera)->rmse_m, 1e-12);
  EXPECT_EQ(ComputeAbsoluteError3d(Poses(5), Poses(5))->rmse_m, 0.);
}

TEST(AbsoluteErrorTest, ScaleIsNotAlignedAway) {
  // A cross of half-width 1 against one of 3: each point is 2 off, whatever the rotation.
  const Poses truth = PosesAt({{1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}});
  const Poses estimate = Scaled(truth, 3.);
  const auto error = ComputeAbsoluteError3d(truth, estimate);
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->rmse_m, 2., 1e-12);
  for (const double error_m : error->errors_m) EXPECT_NEAR(error_m, 2., 1e-12);
  EXPECT_LT((error->deviations.col(0) - Eigen::Vector3d(2., 0., 0.)).norm(), 1e-12);
  EXPECT_NEAR(ComputeAbsoluteError2d(truth, estimate, VehicleFrame::kLidar)->rmse_m, 2., 1e-12);
}

TEST(AbsoluteErrorTest, OnePercentOfScaleAlongALine) {
  // A line leaves the rotation about itself open; the error must not care.
  const Poses truth = StraightDrive(101, 1.);
  const Poses estimate = Scaled(truth, 1.01);
  const double expected = 0.01 * SpreadOfIndices(101);
  EXPECT_NEAR(ComputeAbsoluteError3d(truth, estimate)->rmse_m, expected, 1e-10);
  EXPECT_NEAR(ComputeAbsoluteError2d(truth, estimate, VehicleFrame::kLidar)->rmse_m, expected,
              1e-10);
}

TEST(AbsoluteErrorTest, RmseIsOfThePerPoseErrors) {
  std::mt19937 random(2);
  const Poses truth = RandomDrive(200, &random);
  const auto error = ComputeAbsoluteError3d(truth, WithDrift(truth, &random));
  ASSERT_TRUE(error);
  ASSERT_EQ(error->errors_m.size(), 200);
  ASSERT_EQ(error->deviations.cols(), 200);
  double sum = 0.;
  for (int i = 0; i < 200; ++i) {
    EXPECT_NEAR(error->deviations.col(i).norm(), error->errors_m[i], 1e-12);
    sum += error->errors_m[i] * error->errors_m[i];
  }
  EXPECT_GT(error->rmse_m, 1e-3);
  EXPECT_NEAR(error->rmse_m, std::sqrt(sum / 200), 1e-12);
}

TEST(AbsoluteErrorTest, NoRigidMotionDoesBetter) {
  std::mt19937 random(3);
  const Poses truth = RandomDrive(150, &random);
  const Poses estimate = WithDrift(truth, &random);
  const auto error = ComputeAbsoluteError3d(truth, estimate);
  ASSERT_TRUE(error);
  // The aligned estimate, moved a little in random directions.
  for (int trial = 0; trial < 200; ++trial) {
    const Rigid3d nudge = RandomMotion(&random, 0.01, 1e-4);
    double sum = 0.;
    for (size_t i = 0; i < truth.size(); ++i) {
      const Eigen::Vector3d aligned = truth[i].translation() + error->deviations.col(i);
      sum += (nudge * aligned - truth[i].translation()).squaredNorm();
    }
    EXPECT_GE(std::sqrt(sum / truth.size()), error->rmse_m);
  }
}

TEST(AbsoluteErrorTest, AMirrorImageIsNoAlignment) {
  const Poses truth = PosesAt({{0., 0., 0.}, {1., 0., 0.}, {0., 2., 0.}, {0., 0., 3.}});
  Poses mirrored;
  for (const Rigid3d& pose : truth) {
    mirrored.push_back(
        Rigid3d::Translation(pose.translation().cwiseProduct(Eigen::Vector3d(1., -1., 1.))));
  }
  EXPECT_GT(ComputeAbsoluteError3d(truth, mirrored)->rmse_m, 0.1);
  // Flat shapes: turned over in space they match, in the plane they do not.
  const Poses flat = PosesAt({{0., 0., 0.}, {1., 0., 0.}, {0., 2., 0.}});
  const Poses flat_mirrored = PosesAt({{0., 0., 0.}, {1., 0., 0.}, {0., -2., 0.}});
  EXPECT_LT(ComputeAbsoluteError3d(flat, flat_mirrored)->rmse_m, 1e-12);
  EXPECT_GT(ComputeAbsoluteError2d(flat, flat_mirrored, VehicleFrame::kLidar)->rmse_m, 0.1);
}

TEST(AbsoluteErrorTest, WorldsDoNotMatter) {
  std::mt19937 random(4);
  const Poses truth = RandomDrive(200, &random);
  const Poses estimate = WithDrift(truth, &random);
  const double expected_3d = ComputeAbsoluteError3d(truth, estimate)->rmse_m;
  for (int trial = 0; trial < 10; ++trial) {
    const Poses moved_truth = Moved(RandomMotion(&random, 50., 2.), truth);
    const Poses moved = Moved(RandomMotion(&random, 50., 2.), estimate);
    EXPECT_NEAR(ComputeAbsoluteError3d(moved_truth, moved)->rmse_m, expected_3d, 1e-9);
    for (const VehicleFrame frame : {VehicleFrame::kCamera, VehicleFrame::kLidar}) {
      EXPECT_NEAR(ComputeAbsoluteError2d(moved_truth, moved, frame)->rmse_m,
                  ComputeAbsoluteError2d(truth, estimate, frame)->rmse_m, 1e-9);
    }
  }
}

TEST(AbsoluteErrorTest, EstimateAndTruthMaySwap) {
  std::mt19937 random(5);
  const Poses truth = RandomDrive(100, &random);
  const Poses estimate = WithDrift(truth, &random);
  EXPECT_NEAR(ComputeAbsoluteError3d(truth, estimate)->rmse_m,
              ComputeAbsoluteError3d(estimate, truth)->rmse_m, 1e-10);
}

TEST(AbsoluteErrorTest, HeightsCountInSpaceAlone) {
  // Square drives whose estimate has bumps in the upward direction of one frame.
  const Poses lidar = PosesAt({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}});
  const Poses lidar_bumps = PosesAt({{0, 0, 0}, {9, 0, 1}, {9, 9, 0}, {0, 9, 1}});
  EXPECT_GT(ComputeAbsoluteError3d(lidar, lidar_bumps)->rmse_m, 0.4);
  EXPECT_LT(ComputeAbsoluteError2d(lidar, lidar_bumps, VehicleFrame::kLidar)->rmse_m, 1e-12);
  EXPECT_GT(ComputeAbsoluteError2d(lidar, lidar_bumps, VehicleFrame::kCamera)->rmse_m, 0.1);
  const Poses camera = PosesAt({{0, 0, 0}, {9, 0, 0}, {9, 0, 9}, {0, 0, 9}});
  const Poses camera_bumps = PosesAt({{0, 0, 0}, {9, 1, 0}, {9, 0, 9}, {0, 1, 9}});
  EXPECT_LT(ComputeAbsoluteError2d(camera, camera_bumps, VehicleFrame::kCamera)->rmse_m, 1e-12);
  EXPECT_GT(ComputeAbsoluteError2d(camera, camera_bumps, VehicleFrame::kLidar)->rmse_m, 0.1);
}

TEST(AbsoluteErrorTest, HeightsAreDroppedBeforeTheAlignment) {
  // The estimate climbs at 60 degrees where the truth is level. Aligned in space first it would be
  // perfect; seen from above it covers half of the way.
  const Poses truth = StraightDrive(101, 1.);
  Poses climbing;
  for (const Rigid3d& pose : truth) {
    climbing.push_back(
        Rigid3d::Translation(pose.translation().x() * Eigen::Vector3d(0.5, 0., std::sqrt(0.75))));
  }
  EXPECT_LT(ComputeAbsoluteError3d(truth, climbing)->rmse_m, 1e-10);
  EXPECT_NEAR(ComputeAbsoluteError2d(truth, climbing, VehicleFrame::kLidar)->rmse_m,
              0.5 * SpreadOfIndices(101), 1e-10);
}

TEST(AbsoluteErrorTest, MisuseIsABug) {
  Poses broken = StraightDrive(9, 1.);
  broken[7] = Rigid3d::Translation({NAN, 0., 0.});
  EXPECT_DEATH(ComputeAbsoluteError3d(StraightDrive(9, 1.), broken), "allFinite");
  EXPECT_DEATH(ComputeAbsoluteError2d(StraightDrive(9, 1.), broken, VehicleFrame::kLidar),
               "allFinite");
  EXPECT_DEATH(ComputeAbsoluteError3d(StraightDrive(9, 1.), StraightDrive(8, 1.)), "size");
}

}  // namespace
}  // namespace semantic_kiss::evaluation
