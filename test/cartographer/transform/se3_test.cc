// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/transform/se3.h"

#include <cmath>
#include <random>

namespace cartographer::transform {
namespace {

Twist RandomTwist(std::mt19937* random, double max_angle) {
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Twist twist;
  for (int i = 0; i < 6; ++i) twist[i] = uniform(*random);
  twist.tail<3>() *= max_angle / twist.tail<3>().norm() * std::abs(uniform(*random));
  return twist;
}

TEST(Se3Test, LogInvertsExp) {
  std::mt19937 random(1);
  for (const double max_angle : {1e-9, 1e-4, 1e-2, 1., 3.14}) {
    for (int i = 0; i < 200; ++i) {
      const Twist twist = RandomTwist(&random, max_angle);
      EXPECT_LT((Log(Exp(twist)) - twist).norm(), 1e-9) << twist.transpose();
    }
  }
}

TEST(Se3Test, ExpOfZeroIsIdentity) {
  EXPECT_EQ(Exp(Twist::Zero()).Matrix(), Rigid3d().Matrix());
  EXPECT_EQ(Log(Rigid3d()), Twist::Zero());
}

TEST(Se3Test, ExpIsContinuousWhereTheSeriesTakesOver) {
  Twist twist;
  twist << 1., 2., 3., 0.6, 0.8, 0.;
  Twist below = twist, above = twist;
  below.tail<3>() *= 1e-4 * (1. - 1e-9);
  above.tail<3>() *= 1e-4 * (1. + 1e-9);
  EXPECT_LT((Exp(below).Matrix() - Exp(above).Matrix()).norm(), 1e-12);
}

TEST(Se3Test, ExpOfPureRotationAboutZ) {
  Twist twist = Twist::Zero();
  twist[5] = M_PI / 2.;
  const Eigen::Vector3d rotated = Exp(twist) * Eigen::Vector3d::UnitX();
  EXPECT_LT((rotated - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

TEST(Se3Test, LogHandlesHalfTurns) {
  const Rigid3d half_turn =
      Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY())));
  const Twist twist = Log(half_turn);
  EXPECT_NEAR(twist.tail<3>().norm(), M_PI, 1e-9);
  EXPECT_LT((Exp(twist).Matrix() - half_turn.Matrix()).norm(), 1e-9);
}

TEST(Se3Test, HatIsTheCrossProduct) {
  const Eigen::Vector3d a(1., -2., 3.), b(0.5, 4., -1.);
  EXPECT_EQ(Hat(a) * b, a.cross(b));
}

TEST(Se3Test, InterpolateMeetsBothEndsAndExtrapolates) {
  std::mt19937 random(2);
  const Rigid3d start = Exp(RandomTwist(&random, 1.));
  const Twist motion = RandomTwist(&random, 0.5);
  const Rigid3d end = start * Exp(motion);
  EXPECT_LT((Interpolate(start, end, 0.).Matrix() - start.Matrix()).norm(), 1e-12);
  EXPECT_LT((Interpolate(start, end, 1.).Matrix() - end.Matrix()).norm(), 1e-12);
  const Rigid3d beyond = end * Exp(motion);
  EXPECT_LT((Interpolate(start, end, 2.).Matrix() - beyond.Matrix()).norm(), 1e-12);
}

}  // namespace
}  // namespace cartographer::transform
