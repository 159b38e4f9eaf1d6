// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/constraint_information.h"

#include <Eigen/LU>
#include <random>

namespace cartographer::pose_graph {
namespace {

using transform::Matrix6d;

constexpr int kPlanar[] = {0, 1, 5};

Matrix6d RandomInformation(std::mt19937* random) {
  std::normal_distribution<double> normal;
  const Matrix6d root = Matrix6d::NullaryExpr([&] { return normal(*random); });
  return root * root.transpose() + 0.1 * Matrix6d::Identity();
}

TEST(ConstraintInformationTest, IsInFullIfKnownElseFromTheWeights) {
  submap::Constraint constraint;
  constraint.translation_weight = 2.;
  constraint.rotation_weight = 3.;
  transform::Twist diagonal;
  diagonal << 4., 4., 4., 9., 9., 9.;
  EXPECT_EQ(InformationOf(constraint), Matrix6d(diagonal.asDiagonal()));
  std::mt19937 random(1);
  constraint.information = RandomInformation(&random);
  EXPECT_EQ(InformationOf(constraint), *constraint.information);
}

TEST(ConstraintInformationTest, SquareRootSquaredIsTheInformation) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const Matrix6d information = RandomInformation(&random);
    const Matrix6d root = SquareRoot(information);
    EXPECT_LT((root.transpose() * root - information).norm(), 1e-10);
  }
}

TEST(ConstraintInformationTest, SquareRootOfWhatSaysNothingIsZero) {
  EXPECT_EQ(SquareRoot(Matrix6d::Zero()), Matrix6d::Zero());
}

TEST(ConstraintInformationTest, SquareRootTakesSingularInformation) {
  transform::Twist row;
  row << 1., 2., 0., 0., -1., 3.;
  const Matrix6d information = row * row.transpose();
  const Matrix6d root = SquareRoot(information);
  EXPECT_LT((root.transpose() * root - information).norm(), 1e-12);
}

TEST(ConstraintInformationTest, PlanarInformationIsTheInverseOfThatPartOfTheCovariance) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Matrix6d information = RandomInformation(&random);
    const Eigen::Matrix3d covariance = information.inverse()(kPlanar, kPlanar);
    Matrix6d expected = Matrix6d::Zero();
    expected(kPlanar, kPlanar) = covariance.inverse();
    EXPECT_LT((PlanarInformation(information) - expected).norm(), 1e-9 * expected.norm());
  }
}

TEST(ConstraintInformationTest, PlanarInformationTakesSilenceAboutTheRest) {
  Matrix6d information = Matrix6d::Zero();
  information(kPlanar, kPlanar) = Eigen::Vector3d(4., 5., 6.).asDiagonal();
  EXPECT_EQ(PlanarInformation(information), information);
}

}  // namespace
}  // namespace cartographer::pose_graph
