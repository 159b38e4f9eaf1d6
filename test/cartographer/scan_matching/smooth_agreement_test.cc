// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/smooth_agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::scan_matching {
namespace {

constexpr double kResolution_m = 0.5;

// The cubic B-spline around 0, from its textbook definition.
double CubicSpline(double x) {
  const double a = std::abs(x);
  if (a >= 2.) return 0.;
  if (a >= 1.) return std::pow(2. - a, 3) / 6.;
  return 2. / 3. - a * a + a * a * a / 2.;
}

class SmoothAgreementTest : public ::testing::Test {
 protected:
  SmoothAgreementTest()
      : random_(5),
        options_(SmallOptions("dominant_label", 0.3)),
        model_(SmallModel(options_)),
        scene_(20, 300, 10, 5., &random_),
        pyramid_(scene_.grid, model_),
        agreement_(pyramid_, kResolution_m) {}

  Eigen::Vector2d RandomPosition() {
    std::uniform_real_distribution<double> coordinate(-7., 7.);
    return {coordinate(random_), coordinate(random_)};
  }

  std::mt19937 random_;
  const proto::ScoreOptions options_;
  const ScoreModel model_;
  const RandomScene scene_;
  const ScorePyramid pyramid_;
  const SmoothAgreement agreement_;
};

TEST_F(SmoothAgreementTest, IsTheSumOfSplinesOverTheCells) {
  const PlainScore plain(options_, scene_.grid);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d position = RandomPosition();
    const int label = 1 + i % 7;
    double expected = 0.;
    for (int y = -20; y < 20; ++y) {
      for (int x = -20; x < 20; ++x) {
        const Eigen::Vector2d offset = position / kResolution_m - Eigen::Vector2d(x + 0.5, y + 0.5);
        expected += CubicSpline(offset.x()) * CubicSpline(offset.y()) *
                    plain.Agreement(label, x, y) / ScoreModel::kFullAgreement;
      }
    }
    const int layer = model_.LayerOf(LabelAt(label));
    EXPECT_NEAR(agreement_.At(layer, position).value, expected, 1e-12);
  }
}

TEST_F(SmoothAgreementTest, GradientsEqualNumericOnes) {
  constexpr double kStep_m = 1e-6;
  double steepest = 0.;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d position = RandomPosition();
    const int layer = i % model_.num_layers();
    const Eigen::Vector2d gradient = agreement_.At(layer, position).gradient;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = kStep_m * Eigen::Vector2d::Unit(axis);
      const double numeric = (agreement_.At(layer, position + step).value -
                              agreement_.At(layer, position - step).value) /
                             (2. * kStep_m);
      EXPECT_NEAR(gradient[axis], numeric, 1e-7);
    }
    steepest = std::max(steepest, gradient.norm());
  }
  EXPECT_GT(steepest, 0.1);
}

TEST(SmoothAgreementOfOneCellTest, IsOneInsideAndZeroAwayFromWhatWasHit) {
  submap::SemanticGrid grid(kResolution_m);
  for (int y = -4; y < 4; ++y) {
    for (int x = -4; x < 4; ++x) grid.AddHits(LabelAt(4), {x, y}, 100);
  }
  const ScoreModel model = SmallModel(SmallOptions("dominant_label"));
  const ScorePyramid pyramid(grid, model);
  const SmoothAgreement agreement(pyramid, kResolution_m);
  const int building = model.LayerOf(LabelAt(4));
  EXPECT_NEAR(agreement.At(building, {0.1, -0.2}).value, 1., 1e-12);
  EXPECT_NEAR(agreement.At(building, {0.1, -0.2}).gradient.norm(), 0., 1e-12);
  // At an edge, half of it.
  EXPECT_NEAR(agreement.At(building, {2., 0.}).value, 0.5, 1e-12);
  EXPECT_LT(agreement.At(building, {2., 0.}).gradient.x(), 0.);
  EXPECT_EQ(agreement.At(building, {3.01, 0.}).value, 0.);
  EXPECT_EQ(agreement.At(building, {0., -3.01}).value, 0.);
  EXPECT_EQ(agreement.At(building, {1e6, -1e6}).value, 0.);
  EXPECT_EQ(agreement.At(model.LayerOf(LabelAt(5)), {0., 0.}).value, 0.);
}

}  // namespace
}  // namespace cartographer::scan_matching
