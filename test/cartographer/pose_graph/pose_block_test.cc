// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/pose_block.h"

#include <cmath>
#include <memory>
#include <random>

#include "cartographer/transform/se3.h"
#include "test/testing/small_map.h"

namespace cartographer::pose_graph {
namespace {

using semantic_kiss_testing::RandomPose;
using transform::Rigid3d;

double Difference(const Rigid3d& a, const Rigid3d& b) { return (a.Matrix() - b.Matrix()).norm(); }

Rigid3d Plus(const ceres::Manifold& manifold, const Rigid3d& pose, const Eigen::VectorXd& delta) {
  const PoseBlock block = ToBlock(pose);
  PoseBlock result;
  EXPECT_TRUE(manifold.Plus(block.data(), delta.data(), result.data()));
  return FromBlock(result.data());
}

TEST(PoseBlockTest, KeepsAllBits) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Rigid3d pose = RandomPose(&random);
    const Rigid3d back = FromBlock(ToBlock(pose).data());
    EXPECT_EQ(back.translation(), pose.translation());
    EXPECT_EQ(back.rotation().coeffs(), pose.rotation().coeffs());
  }
}

class ManifoldTest : public ::testing::TestWithParam<bool> {
 protected:
  const std::unique_ptr<ceres::Manifold> manifold_ =
      GetParam() ? std::unique_ptr<ceres::Manifold>(new PlanarPoseManifold)
                 : std::unique_ptr<ceres::Manifold>(new PoseManifold);
};
INSTANTIATE_TEST_SUITE_P(All, ManifoldTest, ::testing::Bool());

TEST_P(ManifoldTest, MinusInvertsPlus) {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const Rigid3d pose = RandomPose(&random);
    const Eigen::VectorXd delta = Eigen::VectorXd::Random(manifold_->TangentSize());
    const PoseBlock from = ToBlock(pose);
    const PoseBlock to = ToBlock(Plus(*manifold_, pose, delta));
    Eigen::VectorXd back(manifold_->TangentSize());
    ASSERT_TRUE(manifold_->Minus(to.data(), from.data(), back.data()));
    EXPECT_LT((back - delta).norm(), 1e-9);
    EXPECT_LT(Difference(Plus(*manifold_, pose, Eigen::VectorXd::Zero(delta.size())), pose), 1e-13);
  }
}

// The first six rows of the Jacobian say by which twist from the right each step moves the pose.
TEST_P(ManifoldTest, JacobianIsTheTwistOfEachStep) {
  constexpr double kStep = 1e-5;
  std::mt19937 random(3);
  const int size = manifold_->TangentSize();
  for (int i = 0; i < 20; ++i) {
    const Rigid3d pose = RandomPose(&random);
    const PoseBlock block = ToBlock(pose);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(7, size);
    ASSERT_TRUE(manifold_->PlusJacobian(block.data(), jacobian.data()));
    EXPECT_EQ(jacobian.row(6).norm(), 0.);
    for (int k = 0; k < size; ++k) {
      const Eigen::VectorXd delta = kStep * Eigen::VectorXd::Unit(size, k);
      const transform::Twist twist =
          transform::Log(pose.inverse() * Plus(*manifold_, pose, delta)) / kStep;
      EXPECT_LT((jacobian.col(k).head<6>() - twist).norm(), 1e-4);
    }
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> inverse(size, 7);
    ASSERT_TRUE(manifold_->MinusJacobian(block.data(), inverse.data()));
    EXPECT_LT((inverse * jacobian - Eigen::MatrixXd::Identity(size, size)).norm(), 1e-12);
  }
}

TEST(PlanarPoseManifoldTest, KeepsHeightAndTilt) {
  std::mt19937 random(4);
  const PlanarPoseManifold manifold;
  for (int i = 0; i < 20; ++i) {
    const Rigid3d pose = RandomPose(&random);
    const Rigid3d moved = Plus(manifold, pose, Eigen::Vector3d(3., -2., 1.5));
    EXPECT_EQ(moved.translation().z(), pose.translation().z());
    EXPECT_NEAR(moved.translation().x(), pose.translation().x() + 3., 1e-12);
    // Where "up" is, seen from the pose.
    EXPECT_LT((moved.rotation().conjugate() * Eigen::Vector3d::UnitZ() -
               pose.rotation().conjugate() * Eigen::Vector3d::UnitZ())
                  .norm(),
              1e-12);
  }
}

TEST(MovedInPlaneTest, TakesPositionAndHeadingAndKeepsTheRest) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    const Rigid3d pose = RandomPose(&random);
    const Rigid3d target = RandomPose(&random);
    const Rigid3d moved = MovedInPlane(pose, target);
    EXPECT_EQ(moved.translation().head<2>(), target.translation().head<2>());
    EXPECT_EQ(moved.translation().z(), pose.translation().z());
    EXPECT_NEAR(std::remainder(transform::Yaw(moved.rotation()) - transform::Yaw(target.rotation()),
                               2. * M_PI),
                0., 1e-12);
    EXPECT_LT((moved.rotation().conjugate() * Eigen::Vector3d::UnitZ() -
               pose.rotation().conjugate() * Eigen::Vector3d::UnitZ())
                  .norm(),
              1e-12);
  }
  const Rigid3d pose = RandomPose(&random);
  EXPECT_LT(Difference(MovedInPlane(pose, pose), pose), 1e-15);
}

}  // namespace
}  // namespace cartographer::pose_graph
