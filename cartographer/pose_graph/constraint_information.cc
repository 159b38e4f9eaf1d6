// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/constraint_information.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace cartographer::pose_graph {

using transform::Matrix6d;

Matrix6d InformationOf(const submap::Constraint& constraint) {
  if (constraint.information.has_value()) return *constraint.information;
  transform::Twist weights;
  weights.head<3>().setConstant(constraint.translation_weight);
  weights.tail<3>().setConstant(constraint.rotation_weight);
  return weights.cwiseAbs2().asDiagonal();
}

Matrix6d PlanarInformation(const Matrix6d& information) {
  constexpr int kPlanar[] = {0, 1, 5};
  constexpr int kVertical[] = {2, 3, 4};
  const Eigen::Matrix3d across = information(kPlanar, kVertical);
  const Eigen::Matrix3d vertical = information(kVertical, kVertical);
  Matrix6d result = Matrix6d::Zero();
  result(kPlanar, kPlanar) =
      information(kPlanar, kPlanar) - across * vertical.ldlt().solve(across.transpose().eval());
  return result;
}

Matrix6d SquareRoot(const Matrix6d& information) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(information);
  return solver.eigenvalues().cwiseMax(0.).cwiseSqrt().asDiagonal() *
         solver.eigenvectors().transpose();
}

}  // namespace cartographer::pose_graph
