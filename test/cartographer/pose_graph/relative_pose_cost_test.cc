// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/relative_pose_cost.h"

#include <random>
#include <vector>

namespace cartographer::pose_graph {
namespace {

using transform::Exp;
using transform::Matrix6d;
using transform::Rigid3d;
using transform::Twist;

Twist RandomTwist(std::mt19937* random, double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  Twist twist;
  for (int i = 0; i < 6; ++i) twist[i] = uniform(*random);
  return twist;
}

Rigid3d RandomMotion(std::mt19937* random) {
  Twist twist = RandomTwist(random, 1.5);
  twist.head<3>() *= 20.;
  return Exp(twist);
}

Matrix6d RandomWhitening(std::mt19937* random) {
  Matrix6d matrix;
  for (int i = 0; i < 6; ++i) matrix.col(i) = RandomTwist(random, 1.);
  return matrix + 2. * Matrix6d::Identity();
}

// A cost at two poses and, where it has one, a systematic error.
struct Point {
  Rigid3d a, b;
  Twist systematic;
  int num_blocks;

  Point Perturbed(int block, const Twist& delta) const {
    Point point = *this;
    if (block == 0) point.a = a * Exp(delta);
    if (block == 1) point.b = b * Exp(delta);
    if (block == 2) point.systematic += delta;
    return point;
  }
};

Twist Evaluate(const ceres::CostFunction& cost, const Point& point, double** jacobians) {
  const PoseBlock a = ToBlock(point.a), b = ToBlock(point.b);
  const double* const blocks[] = {a.data(), b.data(), point.systematic.data()};
  Twist residual;
  EXPECT_TRUE(cost.Evaluate(blocks, residual.data(), jacobians));
  return residual;
}

void ExpectJacobiansEqualNumericOnes(const ceres::CostFunction& cost, const Point& point) {
  constexpr double kStep = 1e-5;
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<Jacobian> jacobians = {Jacobian(6, 7), Jacobian(6, 7), Jacobian(6, 6)};
  double* pointers[] = {jacobians[0].data(), jacobians[1].data(), jacobians[2].data()};
  Evaluate(cost, point, pointers);
  for (int block = 0; block < point.num_blocks; ++block) {
    if (block < 2) {
      EXPECT_EQ(jacobians[block].col(6).norm(), 0.);
    }
    for (int k = 0; k < 6; ++k) {
      const Twist delta = kStep * Twist::Unit(k);
      const Twist numeric = (Evaluate(cost, point.Perturbed(block, delta), nullptr) -
                             Evaluate(cost, point.Perturbed(block, -delta), nullptr)) /
                            (2. * kStep);
      EXPECT_LT((jacobians[block].col(k) - numeric).norm(), 1e-6 * (1. + numeric.norm()))
          << "block " << block << ", column " << k;
    }
  }
}

TEST(RelativePoseCostTest, IsZeroWhereTheMeasurementHolds) {
  std::mt19937 random(1);
  const double weight = 1.;
  for (int i = 0; i < 10; ++i) {
    const Rigid3d a = RandomMotion(&random), a_from_b = RandomMotion(&random);
    const RelativePoseCost cost(a_from_b, RandomWhitening(&random), &weight);
    EXPECT_LT(Evaluate(cost, {a, a * a_from_b, Twist::Zero(), 2}, nullptr).norm(), 1e-11);
  }
}

TEST(RelativePoseCostTest, IsTheWhitenedErrorInTheFrameOfB) {
  std::mt19937 random(2);
  const double weight = 0.25;
  const Rigid3d a = RandomMotion(&random), a_from_b = RandomMotion(&random);
  const Matrix6d whitening = RandomWhitening(&random);
  const Twist error = RandomTwist(&random, 0.5);
  const RelativePoseCost cost(a_from_b, whitening, &weight);
  const Twist residual = Evaluate(cost, {a, a * a_from_b * Exp(error), Twist::Zero(), 2}, nullptr);
  EXPECT_LT((residual - 0.5 * whitening * error).norm(), 1e-11);
}

TEST(RelativePoseCostTest, JacobiansEqualNumericOnes) {
  std::mt19937 random(3);
  const double weight = 0.7;
  for (const double error : {0., 1e-6, 0.1, 1.}) {
    for (int i = 0; i < 10; ++i) {
      const Rigid3d a = RandomMotion(&random), a_from_b = RandomMotion(&random);
      const RelativePoseCost cost(a_from_b, RandomWhitening(&random), &weight);
      const Rigid3d b = a * a_from_b * Exp(RandomTwist(&random, error));
      ExpectJacobiansEqualNumericOnes(cost, {a, b, Twist::Zero(), 2});
    }
  }
}

TEST(RelativePoseCostTest, GivesOnlyTheJacobiansThatAreWanted) {
  std::mt19937 random(4);
  const double weight = 1.;
  const RelativePoseCost cost(RandomMotion(&random), Matrix6d::Identity(), &weight);
  const Point point{RandomMotion(&random), RandomMotion(&random), Twist::Zero(), 2};
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> all[2], alone;
  double* both[] = {all[0].data(), all[1].data()};
  double* second[] = {nullptr, alone.data()};
  Evaluate(cost, point, both);
  Evaluate(cost, point, second);
  EXPECT_EQ(alone, all[1]);
}

OdometrySegment RandomSegment(std::mt19937* random) {
  const Matrix6d root = RandomWhitening(random);
  return {RandomMotion(random), 10. * RandomWhitening(random), root * root.transpose()};
}

TEST(OdometryCostTest, IsZeroWhereOdometryAndSystematicErrorExplainThePoses) {
  std::mt19937 random(5);
  const Twist sigmas = Twist::Constant(0.01);
  for (int i = 0; i < 10; ++i) {
    const OdometrySegment segment = RandomSegment(&random);
    const Twist systematic = RandomTwist(&random, 2.);
    const Rigid3d a = RandomMotion(&random);
    const Rigid3d b = a * segment.odometry * Exp(segment.drift * sigmas.cwiseProduct(systematic));
    EXPECT_LT(Evaluate(OdometryCost(segment, sigmas), {a, b, systematic, 3}, nullptr).norm(),
              1e-10);
  }
}

TEST(OdometryCostTest, SquaredNormIsTheMahalanobisDistance) {
  std::mt19937 random(6);
  const OdometrySegment segment = RandomSegment(&random);
  const Twist error = RandomTwist(&random, 0.3);
  const Rigid3d a = RandomMotion(&random);
  const Twist residual =
      Evaluate(OdometryCost(segment, Twist::Zero()),
               {a, a * segment.odometry * Exp(error), Twist::Zero(), 3}, nullptr);
  EXPECT_NEAR(residual.squaredNorm(), error.dot(segment.covariance.inverse() * error), 1e-9);
}

TEST(OdometryCostTest, JacobiansEqualNumericOnes) {
  std::mt19937 random(7);
  Twist sigmas;
  sigmas << 0.01, 0.02, 0.03, 0.004, 0.005, 0.;  // the last is not estimated
  for (const double error : {0., 1e-6, 0.1, 1.}) {
    for (int i = 0; i < 10; ++i) {
      const OdometrySegment segment = RandomSegment(&random);
      const Twist systematic = RandomTwist(&random, 2.);
      const Rigid3d a = RandomMotion(&random);
      const Rigid3d b = a * segment.odometry *
                        Exp(segment.drift * sigmas.cwiseProduct(systematic)) *
                        Exp(RandomTwist(&random, error));
      ExpectJacobiansEqualNumericOnes(OdometryCost(segment, sigmas), {a, b, systematic, 3});
    }
  }
}

}  // namespace
}  // namespace cartographer::pose_graph
