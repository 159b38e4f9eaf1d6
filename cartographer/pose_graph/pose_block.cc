// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/pose_block.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "cartographer/transform/se3.h"

namespace cartographer::pose_graph {
namespace {

using transform::Rigid3d;
using transform::Twist;

template <int rows, int columns>
using RowMajor = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;

Eigen::Quaterniond Turn(double heading_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()));
}

void Write(const Rigid3d& pose, double* block) {
  Eigen::Map<Eigen::Vector3d>{block} = pose.translation();
  Eigen::Map<Eigen::Vector4d>{block + 3} = pose.rotation().coeffs();
}

// The twists in the frame of the pose that planar steps are.
Eigen::Matrix<double, 6, 3> PlanarTwists(const double* block) {
  const Eigen::Matrix3d pose_from_map = FromBlock(block).rotation().conjugate().toRotationMatrix();
  Eigen::Matrix<double, 6, 3> twists = Eigen::Matrix<double, 6, 3>::Zero();
  twists.topLeftCorner<3, 2>() = pose_from_map.leftCols<2>();
  twists.bottomRightCorner<3, 1>() = pose_from_map.col(2);
  return twists;
}

}  // namespace

PoseBlock ToBlock(const Rigid3d& pose) {
  PoseBlock block;
  Write(pose, block.data());
  return block;
}

Rigid3d FromBlock(const double* block) {
  return Rigid3d::FromUnitRotation(
      Eigen::Map<const Eigen::Vector3d>(block),
      Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(block + 3)));
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  Write(FromBlock(x) * transform::Exp(Eigen::Map<const Twist>(delta)), x_plus_delta);
  return true;
}

bool PoseManifold::PlusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<RowMajor<7, 6>>{jacobian}.setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Twist>{y_minus_x} = transform::Log(FromBlock(x).inverse() * FromBlock(y));
  return true;
}

bool PoseManifold::MinusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<RowMajor<6, 7>>{jacobian}.setIdentity();
  return true;
}

bool PlanarPoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const Rigid3d pose = FromBlock(x);
  const Eigen::Vector3d step(delta[0], delta[1], 0.);
  Write(Rigid3d(pose.translation() + step, Turn(delta[2]) * pose.rotation()), x_plus_delta);
  return true;
}

bool PlanarPoseManifold::PlusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<RowMajor<7, 3>> map(jacobian);
  map.setZero();
  map.topRows<6>() = PlanarTwists(x);
  return true;
}

bool PlanarPoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  const Rigid3d to = FromBlock(y);
  const Rigid3d from = FromBlock(x);
  y_minus_x[0] = to.translation().x() - from.translation().x();
  y_minus_x[1] = to.translation().y() - from.translation().y();
  y_minus_x[2] = transform::Yaw(to.rotation() * from.rotation().conjugate());
  return true;
}

bool PlanarPoseManifold::MinusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<RowMajor<3, 7>> map(jacobian);
  map.setZero();
  map.leftCols<6>() = PlanarTwists(x).transpose();
  return true;
}

Rigid3d MovedInPlane(const Rigid3d& pose, const Rigid3d& target) {
  const double turn_rad = transform::Yaw(target.rotation()) - transform::Yaw(pose.rotation());
  const Eigen::Vector3d& to = target.translation();
  return Rigid3d(Eigen::Vector3d(to.x(), to.y(), pose.translation().z()),
                 Turn(turn_rad) * pose.rotation());
}

}  // namespace cartographer::pose_graph
