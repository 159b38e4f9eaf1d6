// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/relative_pose_cost.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace cartographer::pose_graph {
namespace {

using transform::Adjoint;
using transform::Matrix6d;
using transform::Rigid3d;
using transform::Twist;

using PoseJacobian = Eigen::Matrix<double, 6, kPoseBlockSize, Eigen::RowMajor>;
using TwistJacobian = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

void WritePoseJacobian(const Matrix6d& by_twist, double* jacobian) {
  Eigen::Map<PoseJacobian> map(jacobian);
  map.leftCols<6>() = by_twist;
  map.col(6).setZero();
}

// With error = measured^-1 * a_from_b = Exp(xi), a perturbation of b adds J^-1(xi) * delta to xi,
// one of a is first carried over to b, from the other side.
void WritePoseJacobians(const Matrix6d& by_error, const Rigid3d& b_from_a, double** jacobians) {
  if (jacobians[0] != nullptr) WritePoseJacobian(-by_error * Adjoint(b_from_a), jacobians[0]);
  if (jacobians[1] != nullptr) WritePoseJacobian(by_error, jacobians[1]);
}

}  // namespace

RelativePoseCost::RelativePoseCost(const Rigid3d& a_from_b, const Matrix6d& sqrt_information,
                                   const double* weight)
    : b_from_a_(a_from_b.inverse()), sqrt_information_(sqrt_information), weight_(weight) {}

bool RelativePoseCost::Evaluate(const double* const* poses, double* residuals,
                                double** jacobians) const {
  const Rigid3d a_from_b = FromBlock(poses[0]).inverse() * FromBlock(poses[1]);
  const Twist error = transform::Log(b_from_a_ * a_from_b);
  const Matrix6d whitening = std::sqrt(*weight_) * sqrt_information_;
  Eigen::Map<Twist>{residuals} = whitening * error;
  if (jacobians == nullptr) return true;
  WritePoseJacobians(whitening * transform::InverseRightJacobian(error), a_from_b.inverse(),
                     jacobians);
  return true;
}

OdometryCost::OdometryCost(const OdometrySegment& segment, const Twist& systematic_sigmas)
    : end_from_start_(segment.odometry.inverse()),
      drift_(segment.drift * systematic_sigmas.asDiagonal()),
      sqrt_information_(segment.covariance.llt().matrixL().solve(Matrix6d(Matrix6d::Identity()))) {}

bool OdometryCost::Evaluate(const double* const* parameters, double* residuals,
                            double** jacobians) const {
  const Rigid3d start_from_end = FromBlock(parameters[0]).inverse() * FromBlock(parameters[1]);
  const Twist drift = drift_ * Eigen::Map<const Twist>(parameters[2]);
  const Rigid3d error_pose = transform::Exp(-drift) * end_from_start_ * start_from_end;
  const Twist error = transform::Log(error_pose);
  Eigen::Map<Twist>{residuals} = sqrt_information_ * error;
  if (jacobians == nullptr) return true;
  const Matrix6d by_error = sqrt_information_ * transform::InverseRightJacobian(error);
  WritePoseJacobians(by_error, start_from_end.inverse(), jacobians);
  if (jacobians[2] != nullptr) {
    Eigen::Map<TwistJacobian>{jacobians[2]} =
        -by_error * Adjoint(error_pose.inverse()) * transform::RightJacobian(drift) * drift_;
  }
  return true;
}

}  // namespace cartographer::pose_graph
