// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/fit_to_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/cartographer/scan_matching/room_scene.h"

namespace cartographer::scan_matching {
namespace {

proto::GridFitOptions Options() {
  proto::GridFitOptions options;
  options.set_occupied_space_weight(1.);
  options.set_translation_weight_per_m(0.1);
  options.set_rotation_weight_per_rad(0.1);
  options.set_max_iterations(30);
  options.set_function_tolerance(1e-6);
  return options;
}

const PlanarPose kTruths[] = {
    {{0.03, -0.02}, 0.}, {{1.52, 0.77}, 0.4}, {{-3.01, -1.24}, 3.13}, {{0.5, 2.}, -1.7}};

PlanarPose Displaced(PlanarPose pose, double x, double y, double yaw_rad) {
  pose.translation += Eigen::Vector2d(x, y);
  pose.yaw_rad += yaw_rad;
  return pose;
}

TEST(FitToGridTest, FindsTheTruthFromNearby) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  for (const PlanarPose& truth : kTruths) {
    const PlanarPose guess = Displaced(truth, 0.08, -0.06, 0.008);
    const GridFit fit = FitToGrid(grid, SeenFrom(truth, RoomWalls()), guess, guess, Options());
    EXPECT_TRUE(fit.usable);
    EXPECT_LT((fit.grid_from_scan.translation - truth.translation).norm(), 0.02);
    EXPECT_LT(std::abs(std::remainder(fit.grid_from_scan.yaw_rad - truth.yaw_rad, 2. * M_PI)),
              0.002);
    EXPECT_GT(fit.score, 0.7);
    EXPECT_LT(fit.score, 0.95);
  }
}

TEST(FitToGridTest, WhatTheScanDoesNotShowStaysAsExpected) {
  const submap::ProbabilityGrid grid = GridOf(CorridorWalls());
  PlanarPoints middle;
  for (const Eigen::Vector2d& point : CorridorWalls()) {
    if (std::abs(point.x()) < 5.) middle.push_back(point);
  }
  const PlanarPose expected{{0.6, 0.08}, 0.005};
  const GridFit fit = FitToGrid(grid, middle, expected, expected, Options());
  EXPECT_TRUE(fit.usable);
  EXPECT_NEAR(fit.grid_from_scan.translation.x(), 0.6, 0.02);
  EXPECT_NEAR(fit.grid_from_scan.translation.y(), 0., 0.02);
  EXPECT_NEAR(fit.grid_from_scan.yaw_rad, 0., 0.002);
}

TEST(FitToGridTest, WeightsHoldThePoseWhereItIsExpected) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const PlanarPose expected = Displaced(kTruths[1], 0.08, 0., 0.);
  proto::GridFitOptions options = Options();
  options.set_translation_weight_per_m(1e4);
  options.set_rotation_weight_per_rad(1e4);
  const GridFit fit =
      FitToGrid(grid, SeenFrom(kTruths[1], RoomWalls()), expected, kTruths[1], options);
  EXPECT_LT((fit.grid_from_scan.translation - expected.translation).norm(), 1e-3);
}

TEST(FitToGridTest, NoPointsNoFit) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const GridFit fit = FitToGrid(grid, {}, {}, {{1., 2.}, 0.3}, Options());
  EXPECT_FALSE(fit.usable);
  EXPECT_EQ(fit.grid_from_scan.translation, Eigen::Vector2d(1., 2.));
  EXPECT_EQ(fit.grid_from_scan.yaw_rad, 0.3);
}

TEST(FitToGridTest, JacobiansEqualNumericOnes) {
  constexpr double kStep = 1e-6;
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const proto::GridFitOptions options = Options();
  for (const PlanarPose& truth : kTruths) {
    const PlanarPoints points = SeenFrom(truth, RoomWalls());
    const PlanarPose pose = Displaced(truth, 0.031, -0.027, 0.004);
    const GridFitResiduals residuals(grid, points, truth, options);
    ASSERT_EQ(residuals.size(), static_cast<int>(points.size()) + 3);
    std::vector<double> value(residuals.size()), jacobian(3 * residuals.size());
    residuals.Evaluate(pose, value.data(), jacobian.data());
    std::vector<double> plus(residuals.size()), minus(residuals.size());
    for (int parameter = 0; parameter < 3; ++parameter) {
      const double x = parameter == 0 ? kStep : 0., y = parameter == 1 ? kStep : 0.;
      const double yaw = parameter == 2 ? kStep : 0.;
      residuals.Evaluate(Displaced(pose, x, y, yaw), plus.data(), nullptr);
      residuals.Evaluate(Displaced(pose, -x, -y, -yaw), minus.data(), nullptr);
      for (int i = 0; i < residuals.size(); ++i) {
        EXPECT_NEAR(jacobian[3 * i + parameter], (plus[i] - minus[i]) / (2. * kStep), 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace cartographer::scan_matching
