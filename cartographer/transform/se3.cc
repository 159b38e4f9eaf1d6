// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/transform/se3.h"

#include <cmath>

namespace cartographer::transform {
namespace {

// Below this angle [rad] the closed forms lose digits to cancellation and series take over.
constexpr double kSmallAngle = 1e-4;

Eigen::Quaterniond ExpRotation(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const double half = 0.5 * angle;
  const double sinc_half = angle < kSmallAngle ? 0.5 - angle * angle / 48. : std::sin(half) / angle;
  Eigen::Quaterniond rotation;
  rotation.w() = std::cos(half);
  rotation.vec() = sinc_half * phi;
  return rotation;
}

Eigen::Vector3d LogRotation(const Eigen::Quaterniond& rotation) {
  // q and -q are the same rotation; the one with w >= 0 has the shorter vector.
  const double sign = rotation.w() < 0. ? -1. : 1.;
  const double w = sign * rotation.w();
  const Eigen::Vector3d vec = sign * rotation.vec();
  const double norm = vec.norm();
  if (norm < kSmallAngle) return 2. / w * (1. - norm * norm / (3. * w * w)) * vec;
  return 2. * std::atan2(norm, w) / norm * vec;
}

// V(phi) with Exp([rho, phi]).translation = V * rho (the left Jacobian of SO(3)).
Eigen::Matrix3d LeftJacobian(const Eigen::Vector3d& phi) {
  const double angle2 = phi.squaredNorm();
  const double angle = std::sqrt(angle2);
  const bool small = angle < kSmallAngle;
  const double a = small ? 0.5 - angle2 / 24. : (1. - std::cos(angle)) / angle2;
  const double b = small ? 1. / 6. - angle2 / 120. : (angle - std::sin(angle)) / (angle2 * angle);
  const Eigen::Matrix3d hat = Hat(phi);
  return Eigen::Matrix3d::Identity() + a * hat + b * hat * hat;
}

}  // namespace

Eigen::Matrix3d Hat(const Eigen::Vector3d& vector) {
  Eigen::Matrix3d hat;
  hat << 0., -vector.z(), vector.y(),  //
      vector.z(), 0., -vector.x(),     //
      -vector.y(), vector.x(), 0.;
  return hat;
}

Rigid3d Exp(const Twist& twist) {
  const Eigen::Vector3d phi = twist.tail<3>();
  return Rigid3d(LeftJacobian(phi) * twist.head<3>(), ExpRotation(phi));
}

Twist Log(const Rigid3d& transform) {
  const Eigen::Vector3d phi = LogRotation(transform.rotation());
  Twist twist;
  twist << LeftJacobian(phi).partialPivLu().solve(transform.translation()), phi;
  return twist;
}

Rigid3d Interpolate(const Rigid3d& start, const Rigid3d& end, double fraction) {
  return start * Exp(fraction * Log(start.inverse() * end));
}

}  // namespace cartographer::transform
