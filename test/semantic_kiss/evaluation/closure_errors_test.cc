// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/closure_errors.h"

#include <gtest/gtest.h>

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

// A metre a scan: out along x to 100 m and back 3 m beside it; scan 101 turns.
std::vector<Rigid3d> OutAndBack() {
  std::vector<Rigid3d> poses;
  for (int x = 0; x <= 100; ++x) poses.push_back(Rigid3d::Translation({1. * x, 0., 0.}));
  const Eigen::Quaterniond turned(0., 0., 0., 1.);
  for (int x = 100; x >= 0; --x) poses.push_back({{1. * x, 3., 0.}, turned});
  return poses;
}

RevisitOptions Options() { return {6., 50., 10.}; }

TEST(ClosureErrorsTest, TrueClaimsHaveNone) {
  const std::vector<Rigid3d> truth = OutAndBack();
  const Rigid3d earlier_from_revisit = truth[20].inverse() * truth[180];
  const auto errors = ClosureErrors({{20, 180, earlier_from_revisit}}, truth);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_LT(errors[0].distance_m, 1e-9);
  EXPECT_LT(errors[0].angle_deg, 1e-6);
  EXPECT_FALSE(errors[0].False());
  EXPECT_TRUE(ClosureErrors({}, truth).empty());
}

TEST(ClosureErrorsTest, DistanceAndAngleAreTheClaims) {
  const std::vector<Rigid3d> truth = OutAndBack();
  const Rigid3d truly = truth[20].inverse() * truth[180];
  const Rigid3d shifted = Rigid3d::Translation({0.3, 0.4, 0.}) * truly;
  const Rigid3d turned = truly * Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(
                                     3. * M_PI / 180., Eigen::Vector3d::UnitX())));
  const auto errors = ClosureErrors({{20, 180, shifted}, {20, 180, turned}}, truth);
  EXPECT_NEAR(errors[0].distance_m, 0.5, 1e-9);
  EXPECT_FALSE(errors[0].False());
  EXPECT_NEAR(errors[1].angle_deg, 3., 1e-6);
  EXPECT_TRUE(errors[1].False());
}

TEST(ClosureErrorsTest, ClaimsInThePlaneAreJudgedThere) {
  std::vector<Rigid3d> truth = OutAndBack();
  const Rigid3d level = truth[20].inverse() * truth[180];
  // Both scans are tilted, and the road has risen by 2 m since.
  const auto tilted = [](double angle, const Eigen::Vector3d& axis) {
    return Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)));
  };
  truth[20] = truth[20] * tilted(0.1, Eigen::Vector3d::UnitY());
  truth[180] =
      Rigid3d::Translation({0., 0., 2.}) * truth[180] * tilted(0.1, Eigen::Vector3d::UnitX());
  const Rigid3d moved = Rigid3d::Translation({0.3, 0.4, 0.}) * level;
  const Rigid3d turned = level * tilted(3. * M_PI / 180., Eigen::Vector3d::UnitZ());
  const auto errors = ClosureErrors(
      {{20, 180, level, true}, {20, 180, moved, true}, {20, 180, turned, true}, {20, 180, level}},
      truth);
  EXPECT_NEAR(errors[0].distance_m, 0., 1e-9);
  EXPECT_NEAR(errors[0].angle_deg, 0., 1e-6);
  EXPECT_NEAR(errors[1].distance_m, 0.5, 1e-9);
  EXPECT_NEAR(errors[2].angle_deg, 3., 1e-6);
  EXPECT_TRUE(errors[2].False());
  EXPECT_TRUE(errors[3].False());
}

TEST(ClosureErrorsTest, ClaimsMustBeAboutScansThatExist) {
  EXPECT_DEATH(ClosureErrors({{0, 7, {}}}, std::vector<Rigid3d>(7)), "truth");
}

TEST(RevisitCoverageTest, CountsTheRouteNearClosures) {
  const std::vector<Rigid3d> truth = OutAndBack();
  // On the way back scans are revisits from where 50 m lie in between: x <= 76 or so, 77 m.
  const RevisitCoverage none = ComputeRevisitCoverage({}, truth, Options());
  EXPECT_NEAR(none.revisited_m, 79., 4.);
  EXPECT_EQ(none.closed_m, 0.);
  EXPECT_EQ(*none.ClosedShare(), 0.);
  // 10 m to both sides of a closure.
  const RevisitCoverage one = ComputeRevisitCoverage({{40, 161, {}}}, truth, Options());
  EXPECT_EQ(one.revisited_m, none.revisited_m);
  EXPECT_NEAR(one.closed_m, 21., 1e-9);
  // Two beside each other overlap.
  const RevisitCoverage two =
      ComputeRevisitCoverage({{40, 161, {}}, {36, 165, {}}}, truth, Options());
  EXPECT_NEAR(two.closed_m, 25., 1e-9);
}

TEST(RevisitCoverageTest, NothingRevisitedHasNoShare) {
  const std::vector<Rigid3d> truth = OutAndBack();
  const std::vector<Rigid3d> out(truth.begin(), truth.begin() + 100);
  EXPECT_FALSE(ComputeRevisitCoverage({}, out, Options()).ClosedShare().has_value());
  EXPECT_FALSE(ComputeRevisitCoverage({}, {}, Options()).ClosedShare().has_value());
}

}  // namespace
}  // namespace semantic_kiss::evaluation
