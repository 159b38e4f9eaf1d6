// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/transform/se3_jacobian.h"

#include <cmath>

namespace cartographer::transform {
namespace {

// Below this angle [rad] the closed forms lose digits to cancellation: series up to the fourth
// power, which are good to 1e-13 there, take over.
constexpr double kSmallAngle = 0.05;

// Coefficients of the left Jacobian of SO(3), I + a Hat(phi) + b Hat(phi)^2, of its inverse,
// I - Hat(phi) / 2 + c Hat(phi)^2, and, with b, of Coupling().
struct Coefficients {
  double a, b, c, d, e;
};

Coefficients CoefficientsAt(double angle) {
  const double s = angle * angle;
  if (angle < kSmallAngle) {
    return {1. / 2. - s / 24. * (1. - s / 30.), 1. / 6. - s / 120. * (1. - s / 42.),
            1. / 12. + s / 720. * (1. + s / 42.), 1. / 24. - s / 720. * (1. - s / 56.),
            1. / 120. - s / 2520. * (1. - s / 48.)};
  }
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  return {(1. - cosine) / s, (angle - sine) / (s * angle),
          1. / s - 1. / (2. * angle * std::tan(0.5 * angle)), (s + 2. * cosine - 2.) / (2. * s * s),
          (2. * angle - 3. * sine + angle * cosine) / (2. * s * s * angle)};
}

// The upper right block of the left Jacobian of SE(3): how a rotation that changes turns the
// translation.
Eigen::Matrix3d Coupling(const Eigen::Matrix3d& rho, const Eigen::Matrix3d& phi,
                         const Coefficients& k) {
  const Eigen::Matrix3d phi_rho = phi * rho;
  const Eigen::Matrix3d rho_phi = rho * phi;
  const Eigen::Matrix3d phi_rho_phi = phi_rho * phi;
  return 0.5 * rho + k.b * (phi_rho + rho_phi + phi_rho_phi) +
         k.d * (phi * phi_rho + rho_phi * phi - 3. * phi_rho_phi) +
         k.e * (phi_rho_phi * phi + phi * phi_rho_phi);
}

}  // namespace

Matrix6d Adjoint(const Rigid3d& transform) {
  const Eigen::Matrix3d rotation = transform.rotation().toRotationMatrix();
  Matrix6d adjoint = Matrix6d::Zero();
  adjoint.topLeftCorner<3, 3>() = rotation;
  adjoint.topRightCorner<3, 3>() = Hat(transform.translation()) * rotation;
  adjoint.bottomRightCorner<3, 3>() = rotation;
  return adjoint;
}

// The right Jacobian is the left one of the negative twist.
Matrix6d RightJacobian(const Twist& twist) {
  const Coefficients k = CoefficientsAt(twist.tail<3>().norm());
  const Eigen::Matrix3d rho = Hat(-twist.head<3>());
  const Eigen::Matrix3d phi = Hat(-twist.tail<3>());
  const Eigen::Matrix3d block = Eigen::Matrix3d::Identity() + k.a * phi + k.b * phi * phi;
  Matrix6d jacobian = Matrix6d::Zero();
  jacobian.topLeftCorner<3, 3>() = block;
  jacobian.topRightCorner<3, 3>() = Coupling(rho, phi, k);
  jacobian.bottomRightCorner<3, 3>() = block;
  return jacobian;
}

Matrix6d InverseRightJacobian(const Twist& twist) {
  const Coefficients k = CoefficientsAt(twist.tail<3>().norm());
  const Eigen::Matrix3d rho = Hat(-twist.head<3>());
  const Eigen::Matrix3d phi = Hat(-twist.tail<3>());
  const Eigen::Matrix3d block = Eigen::Matrix3d::Identity() - 0.5 * phi + k.c * phi * phi;
  Matrix6d inverse = Matrix6d::Zero();
  inverse.topLeftCorner<3, 3>() = block;
  inverse.topRightCorner<3, 3>() = -block * Coupling(rho, phi, k) * block;
  inverse.bottomRightCorner<3, 3>() = block;
  return inverse;
}

}  // namespace cartographer::transform
