// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/transform/se3_jacobian.h"

#include <cmath>
#include <random>

namespace cartographer::transform {
namespace {

Twist RandomTwist(std::mt19937* random, double angle) {
  std::normal_distribution<double> normal;
  Twist twist;
  for (int i = 0; i < 6; ++i) twist[i] = normal(*random);
  twist.tail<3>() *= angle / twist.tail<3>().norm();
  return twist;
}

// Central differences of Log(Exp(twist)^-1 * Exp(twist + delta)).
Matrix6d NumericRightJacobian(const Twist& twist) {
  constexpr double kStep = 1e-4;
  const Rigid3d inverse = Exp(twist).inverse();
  Matrix6d jacobian;
  for (int i = 0; i < 6; ++i) {
    const Twist delta = kStep * Twist::Unit(i);
    jacobian.col(i) =
        (Log(inverse * Exp(twist + delta)) - Log(inverse * Exp(twist - delta))) / (2. * kStep);
  }
  return jacobian;
}

TEST(Se3JacobianTest, AdjointMovesATwistThroughATransform) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const Rigid3d transform = Exp(RandomTwist(&random, 2.));
    const Twist twist = RandomTwist(&random, 0.5);
    EXPECT_LT(
        ((transform * Exp(twist)).Matrix() - (Exp(Adjoint(transform) * twist) * transform).Matrix())
            .norm(),
        1e-12);
  }
}

TEST(Se3JacobianTest, RightJacobianEqualsNumericOneAtAllAngles) {
  std::mt19937 random(2);
  for (const double angle : {0., 1e-9, 1e-4, 0.01, 0.049, 0.051, 0.3, 1., 3., 3.14}) {
    for (int i = 0; i < 20; ++i) {
      const Twist twist = RandomTwist(&random, angle);
      EXPECT_LT((RightJacobian(twist) - NumericRightJacobian(twist)).norm(), 1e-7) << angle;
    }
  }
}

TEST(Se3JacobianTest, InverseIsTheInverse) {
  std::mt19937 random(3);
  for (const double angle : {0., 1e-9, 1e-4, 0.01, 0.049, 0.051, 0.3, 1., 3., M_PI}) {
    for (int i = 0; i < 20; ++i) {
      const Twist twist = RandomTwist(&random, angle);
      EXPECT_LT((InverseRightJacobian(twist) * RightJacobian(twist) - Matrix6d::Identity()).norm(),
                1e-11)
          << angle;
    }
  }
}

TEST(Se3JacobianTest, IsContinuousWhereTheSeriesTakesOver) {
  std::mt19937 random(4);
  const Twist twist = RandomTwist(&random, 0.05);
  Twist below = twist, above = twist;
  below.tail<3>() *= 1. - 1e-12;
  above.tail<3>() *= 1. + 1e-12;
  EXPECT_LT((RightJacobian(below) - RightJacobian(above)).norm(), 1e-10);
  EXPECT_LT((InverseRightJacobian(below) - InverseRightJacobian(above)).norm(), 1e-10);
}

TEST(Se3JacobianTest, IsTheIdentityAtZero) {
  EXPECT_EQ(RightJacobian(Twist::Zero()), Matrix6d::Identity());
  EXPECT_EQ(InverseRightJacobian(Twist::Zero()), Matrix6d::Identity());
}

}  // namespace
}  // namespace cartographer::transform
