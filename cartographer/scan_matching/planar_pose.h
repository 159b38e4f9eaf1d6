// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_PLANAR_POSE_H_
#define CARTOGRAPHER_SCAN_MATCHING_PLANAR_POSE_H_

#include <Eigen/Core>

#include "cartographer/transform/rigid_transform.h"

namespace cartographer::scan_matching {

// A pose in the x-y plane of a level frame; variables are named `target_from_source`.
struct PlanarPose {
  Eigen::Vector2d translation{0., 0.};  // [m]
  double yaw_rad = 0.;
};

// Leaves out height, roll and pitch.
inline PlanarPose InPlane(const transform::Rigid3d& pose) {
  return {pose.translation().head<2>(), transform::Yaw(pose.rotation())};
}

// With height 0.
inline transform::Rigid3d InSpace(const PlanarPose& pose) {
  return transform::Rigid3d(
      {pose.translation.x(), pose.translation.y(), 0.},
      Eigen::Quaterniond(Eigen::AngleAxisd(pose.yaw_rad, Eigen::Vector3d::UnitZ())));
}

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_PLANAR_POSE_H_
