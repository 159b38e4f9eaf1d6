// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_TRANSFORM_RIGID_TRANSFORM_H_
#define CARTOGRAPHER_TRANSFORM_RIGID_TRANSFORM_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace cartographer::transform {

// A rigid motion of space, the pose of one frame in another. Variables are named
// `target_from_source`, so that compositions chain by eye:
//   map_from_node = map_from_submap * submap_from_node.
//
// The rotation is a unit quaternion; products renormalize, so that long chains stay rigid.
class Rigid3d {
 public:
  Rigid3d() : translation_(Eigen::Vector3d::Zero()), rotation_(Eigen::Quaterniond::Identity()) {}
  // `rotation` need not be normalized; it must not be zero.
  Rigid3d(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation)
      : translation_(translation), rotation_(rotation.normalized()) {}

  static Rigid3d Identity() { return Rigid3d(); }
  static Rigid3d Translation(const Eigen::Vector3d& translation);
  static Rigid3d Rotation(const Eigen::Quaterniond& rotation);
  // Takes `unit_rotation` as it is, bit by bit: for poses read back from files, which normalizing
  // once more could change.
  static Rigid3d FromUnitRotation(const Eigen::Vector3d& translation,
                                  const Eigen::Quaterniond& unit_rotation);
  // From the upper 3 x 4 part of a homogeneous matrix; its left 3 x 3 block is taken for a
  // rotation matrix (round-off is removed by way of the quaternion).
  static Rigid3d FromMatrix(const Eigen::Matrix<double, 3, 4>& matrix);

  const Eigen::Vector3d& translation() const { return translation_; }
  const Eigen::Quaterniond& rotation() const { return rotation_; }
  Eigen::Matrix<double, 3, 4> Matrix() const;

  Rigid3d inverse() const;
  bool IsFinite() const;

  // "{ t: [x, y, z], q: [w, x, y, z] }"
  std::string DebugString() const;

 private:
  Eigen::Vector3d translation_;
  Eigen::Quaterniond rotation_;
};

inline Rigid3d operator*(const Rigid3d& a_from_b, const Rigid3d& b_from_c) {
  return Rigid3d(a_from_b.rotation() * b_from_c.translation() + a_from_b.translation(),
                 a_from_b.rotation() * b_from_c.rotation());
}

inline Eigen::Vector3d operator*(const Rigid3d& a_from_b, const Eigen::Vector3d& point_in_b) {
  return a_from_b.rotation() * point_in_b + a_from_b.translation();
}

// Angle of the rotation, in [0, pi] rad.
double RotationAngle(const Rigid3d& transform);

// Heading about the z axis, in (-pi, pi] rad.
double Yaw(const Eigen::Quaterniond& rotation);

// The pose with the same position and heading, but level: roll and pitch are removed.
Rigid3d Level(const Rigid3d& pose);

}  // namespace cartographer::transform

#endif  // CARTOGRAPHER_TRANSFORM_RIGID_TRANSFORM_H_
