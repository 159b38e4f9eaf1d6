// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/transform/rigid_transform.h"

#include <cmath>

#include "absl/strings/str_format.h"

namespace cartographer::transform {

Rigid3d Rigid3d::Translation(const Eigen::Vector3d& translation) {
  return Rigid3d(translation, Eigen::Quaterniond::Identity());
}

Rigid3d Rigid3d::Rotation(const Eigen::Quaterniond& rotation) {
  return Rigid3d(Eigen::Vector3d::Zero(), rotation);
}

Rigid3d Rigid3d::FromUnitRotation(const Eigen::Vector3d& translation,
                                  const Eigen::Quaterniond& unit_rotation) {
  Rigid3d result;
  result.translation_ = translation;
  result.rotation_ = unit_rotation;
  return result;
}

Rigid3d Rigid3d::FromMatrix(const Eigen::Matrix<double, 3, 4>& matrix) {
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  return Rigid3d(matrix.col(3), Eigen::Quaterniond(rotation));
}

Eigen::Matrix<double, 3, 4> Rigid3d::Matrix() const {
  Eigen::Matrix<double, 3, 4> matrix;
  matrix << rotation_.toRotationMatrix(), translation_;
  return matrix;
}

Rigid3d Rigid3d::inverse() const {
  const Eigen::Quaterniond inverse_rotation = rotation_.conjugate();
  return Rigid3d(-(inverse_rotation * translation_), inverse_rotation);
}

bool Rigid3d::IsFinite() const {
  return translation_.allFinite() && rotation_.coeffs().allFinite();
}

std::string Rigid3d::DebugString() const {
  return absl::StrFormat("{ t: [%g, %g, %g], q: [%g, %g, %g, %g] }", translation_.x(),
                         translation_.y(), translation_.z(), rotation_.w(), rotation_.x(),
                         rotation_.y(), rotation_.z());
}

double RotationAngle(const Rigid3d& transform) {
  const Eigen::Quaterniond& q = transform.rotation();
  return 2. * std::atan2(q.vec().norm(), std::abs(q.w()));
}

double Yaw(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d heading = rotation * Eigen::Vector3d::UnitX();
  return std::atan2(heading.y(), heading.x());
}

Rigid3d Level(const Rigid3d& pose) {
  return Rigid3d(pose.translation(), Eigen::Quaterniond(Eigen::AngleAxisd(
                                         Yaw(pose.rotation()), Eigen::Vector3d::UnitZ())));
}

}  // namespace cartographer::transform
