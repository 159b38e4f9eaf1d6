// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/search_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cartographer::scan_matching {
namespace {

constexpr double kResolution_m = 0.2;
constexpr double kRadius_m = 50.;

double FarthestTurn(const std::vector<double>& yaws, double center) {
  double farthest = 0.;
  for (const double yaw : yaws) {
    farthest = std::max(farthest, std::abs(std::remainder(yaw - center, 2. * M_PI)));
  }
  return farthest;
}

TEST(SearchSpaceTest, AWindowIsCoveredAndNotLeft) {
  const PlanarPose guess{{3., -4.}, 3.1};
  const SearchSpace space = SpaceAround(guess, {10., 0.5}, kResolution_m, kRadius_m);
  EXPECT_EQ(space.first_shift.x(), -50);
  EXPECT_EQ(space.num_shifts.x(), 101);
  EXPECT_EQ(space.num_shifts.y(), 101);
  EXPECT_DOUBLE_EQ(space.yaws_rad[0], 3.1);
  EXPECT_NEAR(FarthestTurn(space.yaws_rad, 3.1), 0.5, 1e-12);
  const PlanarPose corner = space.PoseAt(0, space.first_shift, kResolution_m);
  EXPECT_LT((corner.translation - Eigen::Vector2d(-7., -14.)).norm(), 1e-9);
}

TEST(SearchSpaceTest, NeighbouringHeadingsAreAtMostACellApartAtTheFarthestPoint) {
  for (const double angular_rad : {0.01, 0.5, 3., M_PI, 100.}) {
    SearchSpace space = SpaceAround({{0., 0.}, -3.}, {0., angular_rad}, kResolution_m, kRadius_m);
    std::vector<double>& yaws = space.yaws_rad;
    for (double& yaw : yaws) yaw = std::remainder(yaw + 3., 2. * M_PI);
    std::sort(yaws.begin(), yaws.end());
    for (size_t i = 1; i < yaws.size(); ++i) {
      EXPECT_LE(2. * kRadius_m * std::sin((yaws[i] - yaws[i - 1]) / 2.), kResolution_m + 1e-9);
      EXPECT_GT(yaws[i], yaws[i - 1] + 1e-6);
    }
    if (angular_rad < M_PI) continue;
    const double gap = yaws.front() + 2. * M_PI - yaws.back();
    EXPECT_LE(2. * kRadius_m * std::sin(gap / 2.), kResolution_m + 1e-9);
    EXPECT_GT(gap, 1e-6);
  }
}

TEST(SearchSpaceTest, HeadingsNearTheGuessComeFirst) {
  const SearchSpace space = SpaceAround({{0., 0.}, 1.}, {0., 0.3}, kResolution_m, kRadius_m);
  for (size_t i = 1; i < space.yaws_rad.size(); ++i) {
    EXPECT_GE(std::abs(space.yaws_rad[i] - 1.), std::abs(space.yaws_rad[i - 1] - 1.) - 1e-12);
  }
}

TEST(SearchSpaceTest, WindowsOfNoSizeHoldTheGuessAlone) {
  const SearchSpace space = SpaceAround({{1., 2.}, 0.5}, {0., 0.}, kResolution_m, kRadius_m);
  EXPECT_EQ(space.yaws_rad, std::vector<double>{0.5});
  EXPECT_TRUE((space.num_shifts == 1).all());
  EXPECT_EQ(space.PoseAt(0, {0, 0}, kResolution_m).translation, Eigen::Vector2d(1., 2.));
}

TEST(SearchSpaceTest, AScanAtTheSensorNeedsFewHeadings) {
  EXPECT_LE(SpaceAround({}, {1., 10.}, kResolution_m, 0.).yaws_rad.size(), 7);
}

TEST(SearchSpaceTest, TheWholeSpaceIsTheCentresOfTheBoxAtAllHeadings) {
  const SearchSpace space = WholeSpace({{-16, 32}, {16, 48}}, kResolution_m, kRadius_m);
  const PlanarPose first = space.PoseAt(0, space.first_shift, kResolution_m);
  const PlanarPose last = space.PoseAt(0, space.first_shift + space.num_shifts - 1, kResolution_m);
  EXPECT_LT((first.translation - Eigen::Vector2d(-3.1, 6.5)).norm(), 1e-9);
  EXPECT_LT((last.translation - Eigen::Vector2d(3.1, 9.5)).norm(), 1e-9);
  EXPECT_GE(FarthestTurn(space.yaws_rad, 0.), 3.13);
}

}  // namespace
}  // namespace cartographer::scan_matching
