// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_TRANSFORM_SE3_JACOBIAN_H_
#define CARTOGRAPHER_TRANSFORM_SE3_JACOBIAN_H_

#include <Eigen/Core>

#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"

namespace cartographer::transform {

// Rows and columns are ordered as Twist.
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Ad(T): T * Exp(xi) = Exp(Ad(T) * xi) * T.
Matrix6d Adjoint(const Rigid3d& transform);

// J(xi) of Exp(xi + delta) = Exp(xi) * Exp(J(xi) * delta) for small delta.
Matrix6d RightJacobian(const Twist& twist);

// Its inverse: Log(Exp(xi) * Exp(delta)) = xi + J(xi)^-1 * delta for small delta. Requires that the
// angle of `twist` is under 2 pi; what Log() returns is.
Matrix6d InverseRightJacobian(const Twist& twist);

}  // namespace cartographer::transform

#endif  // CARTOGRAPHER_TRANSFORM_SE3_JACOBIAN_H_
