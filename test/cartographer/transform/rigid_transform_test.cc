// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/transform/rigid_transform.h"

#include <cmath>

namespace cartographer::transform {
namespace {

Rigid3d SomePose() {
  return Rigid3d(Eigen::Vector3d(1., 2., 3.), Eigen::Quaterniond(Eigen::AngleAxisd(
                                                  0.7, Eigen::Vector3d(1., 2., -1.).normalized())));
}

TEST(RigidTransformTest, InverseUndoes) {
  const Rigid3d pose = SomePose();
  EXPECT_LT(((pose * pose.inverse()).Matrix() - Rigid3d().Matrix()).norm(), 1e-12);
  EXPECT_LT(((pose.inverse() * pose).Matrix() - Rigid3d().Matrix()).norm(), 1e-12);
}

TEST(RigidTransformTest, CompositionActsFromTheRight) {
  const Rigid3d a = SomePose();
  const Rigid3d b = Rigid3d::Translation({0., 5., 0.});
  const Eigen::Vector3d point(-1., 0.5, 2.);
  EXPECT_LT(((a * b) * point - a * (b * point)).norm(), 1e-12);
}

TEST(RigidTransformTest, MatrixRoundTrip) {
  const Rigid3d pose = SomePose();
  EXPECT_LT((Rigid3d::FromMatrix(pose.Matrix()).Matrix() - pose.Matrix()).norm(), 1e-12);
}

TEST(RigidTransformTest, LongProductsStayRigid) {
  Rigid3d product;
  for (int i = 0; i < 100000; ++i) product = product * SomePose();
  EXPECT_NEAR(product.rotation().norm(), 1., 1e-12);
}

TEST(RigidTransformTest, AngleIgnoresTheSignOfTheQuaternion) {
  const Eigen::Quaterniond q(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  EXPECT_NEAR(RotationAngle(Rigid3d::Rotation(q)), 0.3, 1e-12);
  EXPECT_NEAR(RotationAngle(Rigid3d::Rotation(Eigen::Quaterniond(-q.coeffs()))), 0.3, 1e-12);
}

TEST(RigidTransformTest, LevelKeepsPositionAndHeading) {
  const Eigen::Quaterniond heading(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond pitch(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  const Rigid3d level = Level(Rigid3d({1., 2., 3.}, heading * pitch));
  EXPECT_EQ(level.translation(), Eigen::Vector3d(1., 2., 3.));
  EXPECT_NEAR(std::abs(level.rotation().dot(heading)), 1., 1e-12);
}

TEST(RigidTransformTest, FindsNonFiniteNumbers) {
  EXPECT_TRUE(SomePose().IsFinite());
  EXPECT_FALSE(Rigid3d::Translation({NAN, 0., 0.}).IsFinite());
}

}  // namespace
}  // namespace cartographer::transform
