// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/submap_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "test/cartographer/scan_matching/crossing_scene.h"

namespace cartographer::scan_matching {
namespace {

void ExpectWithinACell(const Match& match, const PlanarPose& truth, double radius_m) {
  const Eigen::Vector2d error = match.submap_from_node.translation - truth.translation;
  EXPECT_LE(std::abs(error.x()), kCrossingResolution_m);
  EXPECT_LE(std::abs(error.y()), kCrossingResolution_m);
  const double turn = std::remainder(match.submap_from_node.yaw_rad - truth.yaw_rad, 2. * M_PI);
  EXPECT_LE(std::abs(turn), kCrossingResolution_m / radius_m * 1.01);
}

class SubmapMatcherTest : public CrossingTest {
 protected:
  SubmapMatcherTest() : CrossingTest(11) {}
};

TEST_P(SubmapMatcherTest, FindsTheNodeInAWindow) {
  for (const PlanarPose& truth : kPosesOnCrossing) {
    const MatchingScan scan(ScanFrom(seen_points_, truth), model_);
    PlanarPose guess = truth;
    guess.translation += Eigen::Vector2d(-2.57, 3.11);
    guess.yaw_rad += 0.23;
    const auto match = matcher_.MatchInWindow(scan, guess, {4., 0.3}, 0.3);
    ASSERT_TRUE(match.has_value());
    ExpectWithinACell(*match, truth, scan.radius_m());
    EXPECT_LE(match->score, 1.);
  }
}

TEST_P(SubmapMatcherTest, FindsTheNodeAnywhereInTheSubmapAtAnyHeading) {
  for (const PlanarPose& truth : kPosesOnCrossing) {
    const MatchingScan scan(ScanFrom(seen_points_, truth), model_);
    const auto match = matcher_.MatchInWholeSubmap(scan, 0.3);
    ASSERT_TRUE(match.has_value());
    ExpectWithinACell(*match, truth, scan.radius_m());
  }
}

// A guess that looks the wrong way is corrected only if the window allows for it.
TEST_P(SubmapMatcherTest, FindsTheNodeThatDrivesInTheOppositeDirection) {
  const PlanarPose truth{{2., -1.}, M_PI - 0.02}, guess{{0., 0.}, 0.};
  const MatchingScan scan(ScanFrom(seen_points_, truth), model_);
  const auto match = matcher_.MatchInWindow(scan, guess, {5., M_PI}, 0.3);
  ASSERT_TRUE(match.has_value());
  ExpectWithinACell(*match, truth, scan.radius_m());
  const auto wrong = matcher_.MatchInWindow(scan, guess, {5., 0.5}, 0.);
  EXPECT_TRUE(!wrong.has_value() || wrong->score < 0.8 * match->score);
}

TEST_P(SubmapMatcherTest, TheScoreOfAMatchIsTheScoreAtItsPose) {
  for (const PlanarPose& truth : kPosesOnCrossing) {
    const MatchingScan scan(ScanFrom(seen_points_, truth), model_);
    const auto match = matcher_.MatchInWindow(scan, truth, {2., 0.1}, 0.);
    ASSERT_TRUE(match.has_value());
    EXPECT_NEAR(matcher_.ScoreAt(scan, match->submap_from_node), match->score, 0.01);
    // The truth was among the poses here.
    EXPECT_GE(match->score, matcher_.ScoreAt(scan, truth) - 0.01);
  }
}

TEST_P(SubmapMatcherTest, MinScoreIsInclusive) {
  const MatchingScan scan(ScanFrom(seen_points_, kPosesOnCrossing[0]), model_);
  const auto match = matcher_.MatchInWindow(scan, kPosesOnCrossing[0], {1., 0.1}, 0.);
  ASSERT_TRUE(match.has_value());
  const auto again =
      matcher_.MatchInWindow(scan, kPosesOnCrossing[0], {1., 0.1}, match->score - 1e-12);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->score, match->score);
  EXPECT_FALSE(matcher_.MatchInWindow(scan, kPosesOnCrossing[0], {1., 0.1}, match->score + 1e-6)
                   .has_value());
}

// What stands in no other place is what places the scan: labels tell apart what shapes don't.
TEST(SubmapMatcherLabelsTest, LabelsDecideBetweenLookAlikes) {
  submap::SemanticGrid grid(kCrossingResolution_m);
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < 40; ++i) {
    grid.AddHits(LabelAt(4), {i, 0}, 9);    // a wall
    grid.AddHits(LabelAt(5), {i, 30}, 20);  // a hedge of the same shape, more often hit
    AddPoint(0.2 * i + 0.1, 0.1, 4, &cloud);
  }
  for (const std::string score : {"dominant_label", "max_layer", "occupancy"}) {
    const ScoreModel model = SmallModel(SmallOptions(score));
    const SubmapMatcher matcher(grid, model);
    const MatchingScan scan(cloud, model);
    const double at_hedge = matcher.ScoreAt(scan, {{0., 6.}, 0.});
    EXPECT_EQ(matcher.ScoreAt(scan, {}), 1.);
    EXPECT_EQ(at_hedge, score == "occupancy" ? 1. : 0.) << score;
  }
}

TEST(SubmapMatcherLabelsTest, StrayHitsDoNotMakeThePyramidGrow) {
  submap::SemanticGrid grid(kCrossingResolution_m), with_stray(kCrossingResolution_m);
  for (submap::SemanticGrid* const each : {&grid, &with_stray})
    each->AddHits(LabelAt(4), {5, 5}, 9);
  with_stray.AddHits(LabelAt(4), {2000000, -70000000}, 9);
  const ScoreModel model = SmallModel(SmallOptions("dominant_label"));
  EXPECT_EQ(SubmapMatcher(with_stray, model).num_bytes(), SubmapMatcher(grid, model).num_bytes());
}

INSTANTIATE_TEST_SUITE_P(Scores, SubmapMatcherTest,
                         ::testing::Values("dominant_label", "max_layer", "occupancy"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace cartographer::scan_matching
