// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_TRANSFORM_SE3_H_
#define CARTOGRAPHER_TRANSFORM_SE3_H_

#include <Eigen/Core>

#include "cartographer/transform/rigid_transform.h"

namespace cartographer::transform {

// Element of the Lie algebra se(3): rows 0-2 the translational part rho [m], rows 3-5 the
// rotation vector phi [rad].
using Twist = Eigen::Matrix<double, 6, 1>;

// The skew-symmetric matrix of the cross product: Hat(a) * b = a x b.
Eigen::Matrix3d Hat(const Eigen::Vector3d& vector);

// exp: se(3) -> SE(3). Accurate for small and large angles alike.
Rigid3d Exp(const Twist& twist);

// log: SE(3) -> se(3), with |phi| <= pi; Exp(Log(T)) = T. At |phi| = pi either sign of the axis is
// a solution; one of them is returned.
Twist Log(const Rigid3d& transform);

// The pose at `fraction` of the way (0: start, 1: end; beyond: extrapolation) on the screw motion
// from start to end: start * Exp(fraction * Log(start^-1 * end)).
Rigid3d Interpolate(const Rigid3d& start, const Rigid3d& end, double fraction);

}  // namespace cartographer::transform

#endif  // CARTOGRAPHER_TRANSFORM_SE3_H_
