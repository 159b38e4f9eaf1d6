// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/normal_equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cartographer::registration {
namespace {

using transform::Exp;
using transform::Twist;

struct Pair {
  Eigen::Vector3d source, target;
  double weight;
};

std::vector<Pair> RandomPairs(std::mt19937* random, int size) {
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<Pair> pairs;
  for (int i = 0; i < size; ++i) {
    const auto point = [&] {
      return Eigen::Vector3d(10. * uniform(*random), 10. * uniform(*random), 3. * uniform(*random));
    };
    pairs.push_back({point(), point(), std::abs(uniform(*random))});
  }
  return pairs;
}

NormalEquations Sum(const std::vector<Pair>& pairs) {
  NormalEquations equations;
  for (const Pair& pair : pairs) equations.AddPair(pair.source, pair.target, pair.weight);
  return equations;
}

TEST(NormalEquationsTest, TwoPairsByHand) {
  // s1 = (1, 0, 0) -> q1 = (1, 0.1, 0), weight 2; s2 = (0, 2, 0) -> q2 = (0, 2, -0.2), weight 0.5.
  // Residuals r = s - q: (0, -0.1, 0) and (0, 0, 0.2).
  // sum w r = (0, -0.2, 0.1).
  // s x r: (1,0,0) x (0,-0.1,0) = (0, 0, -0.1); (0,2,0) x (0,0,0.2) = (0.4, 0, 0).
  // sum w s x r = (0.2, 0, -0.2).
  NormalEquations equations;
  equations.AddPair({1., 0., 0.}, {1., 0.1, 0.}, 2.);
  equations.AddPair({0., 2., 0.}, {0., 2., -0.2}, 0.5);
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << 0., -0.2, 0.1, 0.2, 0., -0.2;
  EXPECT_LT((equations.Gradient() - gradient).norm(), 1e-12);

  // sum w = 2.5; sum w s = (2, 1, 0), so the upper right block is -Hat((2, 1, 0)).
  // sum w (|s|^2 I - s s^T) = 2 diag(0, 1, 1) + 0.5 * 4 diag(1, 0, 1) = diag(2, 2, 4).
  Eigen::Matrix<double, 6, 6> hessian;
  hessian << 2.5, 0., 0., 0., 0., -1.,  //
      0., 2.5, 0., 0., 0., 2.,          //
      0., 0., 2.5, 1., -2., 0.,         //
      0., 0., 1., 2., 0., 0.,           //
      0., 0., -2., 0., 2., 0.,          //
      -1., 2., 0., 0., 0., 4.;
  EXPECT_LT((equations.Hessian() - hessian).norm(), 1e-12);
  EXPECT_EQ(equations.num_pairs(), 2);
  EXPECT_NEAR(equations.RootMeanSquareError(), std::sqrt((0.01 + 0.04) / 2.), 1e-12);
}

TEST(NormalEquationsTest, AgreeWithNumericJacobians) {
  constexpr int kSeed = 8;
  std::mt19937 random(kSeed);
  const std::vector<Pair> pairs = RandomPairs(&random, 20);
  Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  constexpr double kStep = 1e-6;
  for (const Pair& pair : pairs) {
    Eigen::Matrix<double, 3, 6> jacobian;
    for (int i = 0; i < 6; ++i) {
      const Twist step = kStep * Twist::Unit(i);
      jacobian.col(i) = (Exp(step) * pair.source - Exp(-step) * pair.source) / (2. * kStep);
    }
    hessian += pair.weight * jacobian.transpose() * jacobian;
    gradient += pair.weight * jacobian.transpose() * (pair.source - pair.target);
  }
  const NormalEquations equations = Sum(pairs);
  EXPECT_LT((equations.Hessian() - hessian).norm() / hessian.norm(), 1e-8);
  EXPECT_LT((equations.Gradient() - gradient).norm() / gradient.norm(), 1e-8);
}

TEST(NormalEquationsTest, StepsReachASmallMotionAtOnce) {
  constexpr int kSeed = 9;
  std::mt19937 random(kSeed);
  Twist motion;
  motion << 1e-4, -2e-4, 5e-5, 1e-5, 2e-5, -3e-5;
  NormalEquations equations;
  for (const Pair& pair : RandomPairs(&random, 50)) {
    equations.AddPair(pair.source, Exp(motion) * pair.source, pair.weight);
  }
  EXPECT_LT((equations.Solve() - motion).norm(), 1e-7);
}

TEST(NormalEquationsTest, PartsAddUp) {
  constexpr int kSeed = 10;
  std::mt19937 random(kSeed);
  const std::vector<Pair> pairs = RandomPairs(&random, 30);
  NormalEquations parts = Sum({pairs.begin(), pairs.begin() + 11});
  parts.Add(Sum({pairs.begin() + 11, pairs.end()}));
  const NormalEquations whole = Sum(pairs);
  EXPECT_LT((parts.Hessian() - whole.Hessian()).norm(), 1e-9);
  EXPECT_LT((parts.Gradient() - whole.Gradient()).norm(), 1e-9);
  EXPECT_EQ(parts.num_pairs(), whole.num_pairs());
  EXPECT_NEAR(parts.weight(), whole.weight(), 1e-12);
}

TEST(NormalEquationsTest, LeverArmTellsLinesFromPlanesAndPoints) {
  NormalEquations line, plane, none;
  for (int i = -5; i <= 5; ++i) {
    const Eigen::Vector3d on_line(10. + i, 3., 1.);
    line.AddPair(on_line, on_line, 1.);
    for (int j = -5; j <= 5; ++j) {
      const Eigen::Vector3d on_plane(10. + i, 3. + j, 1.);
      plane.AddPair(on_plane, on_plane, 1.);
    }
  }
  EXPECT_NEAR(line.MinLeverArm(), 0., 1e-6);
  // Rotations about the x axis move the points of the plane by their y distance, rms sqrt(10).
  EXPECT_NEAR(plane.MinLeverArm(), std::sqrt(10.), 1e-9);
  EXPECT_EQ(none.MinLeverArm(), 0.);
}

TEST(NormalEquationsTest, GemanMcClureWeight) {
  EXPECT_EQ(GemanMcClureWeight(0., 0.5), 1.);
  // (0.5 / (0.5 + 0.25))^2
  EXPECT_NEAR(GemanMcClureWeight(0.25, 0.5), 4. / 9., 1e-12);
}

}  // namespace
}  // namespace cartographer::registration
