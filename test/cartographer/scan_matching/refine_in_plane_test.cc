// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/refine_in_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "test/cartographer/scan_matching/crossing_scene.h"

namespace cartographer::scan_matching {
namespace {

constexpr double kDegree = M_PI / 180.;

proto::RefinementOptions Options() {
  proto::RefinementOptions options;
  options.set_max_iterations(30);
  options.set_function_tolerance(1e-6);
  options.set_max_translation_m(1.);
  options.set_max_rotation_deg(3.);
  return options;
}

class RefineInPlaneTest : public CrossingTest {
 protected:
  RefineInPlaneTest() : CrossingTest(12) {}
};

// A match is within a cell; refined, it is within 5 cm and 0.2 degrees.
TEST_P(RefineInPlaneTest, MovesMatchesToTheTruth) {
  for (const PlanarPose& truth : kPosesOnCrossing) {
    const MatchingScan scan(ScanFrom(seen_points_, truth), model_);
    PlanarPose guess = truth;
    guess.translation += Eigen::Vector2d(-1.07, 0.93);
    guess.yaw_rad += 0.1;
    const auto match = matcher_.MatchInWindow(scan, guess, {2., 0.2}, 0.3);
    ASSERT_TRUE(match.has_value());
    const PlanarRefinement refined =
        RefineInPlane(matcher_, scan, match->submap_from_node, Options());
    EXPECT_TRUE(refined.refined);
    const PlanarPose& pose = refined.submap_from_node;
    EXPECT_LT((pose.translation - truth.translation).norm(), 0.05);
    EXPECT_LT(std::abs(std::remainder(pose.yaw_rad - truth.yaw_rad, 2. * M_PI)), 0.2 * kDegree);
    EXPECT_GT(refined.agreement, 0.5);
    EXPECT_LE(refined.agreement, 1.);
  }
}

TEST_P(RefineInPlaneTest, JacobiansEqualNumericOnes) {
  constexpr double kStep = 1e-6;
  for (const PlanarPose& pose : kPosesOnCrossing) {
    const MatchingScan scan(ScanFrom(seen_points_, pose), model_);
    const AgreementResiduals residuals(matcher_, scan);
    ASSERT_EQ(residuals.size(), static_cast<int>(scan.size()));
    std::vector<double> value(scan.size()), jacobian(3 * scan.size());
    residuals.Evaluate(pose, value.data(), jacobian.data());
    for (int parameter = 0; parameter < 3; ++parameter) {
      std::vector<double> plus(scan.size()), minus(scan.size());
      for (const double sign : {1., -1.}) {
        PlanarPose moved = pose;
        const double step = sign * kStep;
        if (parameter < 2) moved.translation[parameter] += step;
        if (parameter == 2) moved.yaw_rad += step;
        residuals.Evaluate(moved, (sign > 0. ? plus : minus).data(), nullptr);
      }
      for (size_t i = 0; i < scan.size(); ++i) {
        EXPECT_NEAR(jacobian[3 * i + parameter], (plus[i] - minus[i]) / (2. * kStep), 1e-6);
      }
    }
  }
}

TEST_P(RefineInPlaneTest, AgreementIsOneLessTheSumOfSquares) {
  const MatchingScan scan(ScanFrom(seen_points_, kPosesOnCrossing[0]), model_);
  const PlanarRefinement refined = RefineInPlane(matcher_, scan, kPosesOnCrossing[0], Options());
  std::vector<double> value(scan.size());
  AgreementResiduals(matcher_, scan).Evaluate(refined.submap_from_node, value.data(), nullptr);
  double sum = 0.;
  for (const double each : value) sum += each * each;
  EXPECT_NEAR(refined.agreement, 1. - sum, 1e-9);
}

TEST_P(RefineInPlaneTest, StaysWhereNothingPulls) {
  const PlanarPose nowhere{{500., -500.}, 1.};
  const MatchingScan scan(ScanFrom(seen_points_, kPosesOnCrossing[0]), model_);
  const PlanarRefinement lost = RefineInPlane(matcher_, scan, nowhere, Options());
  EXPECT_EQ(lost.submap_from_node.translation, nowhere.translation);
  EXPECT_EQ(lost.submap_from_node.yaw_rad, nowhere.yaw_rad);
  EXPECT_NEAR(lost.agreement, 0., 1e-9);

  const MatchingScan empty({}, model_);
  const PlanarRefinement nothing = RefineInPlane(matcher_, empty, nowhere, Options());
  EXPECT_FALSE(nothing.refined);
  EXPECT_EQ(nothing.submap_from_node.translation, nowhere.translation);
  EXPECT_EQ(nothing.agreement, 0.);
}

TEST_P(RefineInPlaneTest, AnOptimumTooFarAwayIsNotTaken) {
  PlanarPose guess = kPosesOnCrossing[0];
  const MatchingScan scan(ScanFrom(seen_points_, guess), model_);
  guess.translation += Eigen::Vector2d(0.15, 0.1);
  proto::RefinementOptions options = Options();
  EXPECT_TRUE(RefineInPlane(matcher_, scan, guess, options).refined);
  options.set_max_translation_m(0.01);
  const PlanarRefinement kept = RefineInPlane(matcher_, scan, guess, options);
  EXPECT_FALSE(kept.refined);
  EXPECT_EQ(kept.submap_from_node.translation, guess.translation);
  options = Options();
  guess.yaw_rad += 0.5 * kDegree;
  options.set_max_rotation_deg(0.01);
  EXPECT_FALSE(RefineInPlane(matcher_, scan, guess, options).refined);
}

INSTANTIATE_TEST_SUITE_P(Scores, RefineInPlaneTest,
                         ::testing::Values("dominant_label", "max_layer", "occupancy"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace cartographer::scan_matching
