// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/final_error.h"

#include <cmath>

#include "glog/logging.h"

namespace semantic_kiss::evaluation {

using cartographer::transform::Rigid3d;

DriftError ComputeDriftError(const MotionEnds& ground_truth, const MotionEnds& estimate,
                             VehicleFrame frame) {
  const Eigen::Vector3d up = UpAxis(frame);
  const Rigid3d true_motion = ground_truth.first.inverse() * ground_truth.last;
  const Rigid3d motion = estimate.first.inverse() * estimate.last;
  const Eigen::Vector3d offset = motion.translation() - true_motion.translation();
  const Eigen::Quaterniond rotation = motion.rotation() * true_motion.rotation().conjugate();

  DriftError error;
  error.position_error_m = offset.norm();
  error.height_error_m = up.dot(offset);
  error.horizontal_error_m = (offset - error.height_error_m * up).norm();
  error.rotation_error_deg =
      cartographer::transform::RotationAngle(Rigid3d::Rotation(rotation)) * 180. / M_PI;
  // The twist of a swing-twist split; the sign of the quaternion must not matter.
  const double sign = rotation.w() < 0. ? -1. : 1.;
  error.heading_error_deg =
      2. * std::atan2(sign * up.dot(rotation.vec()), sign * rotation.w()) * 180. / M_PI;
  return error;
}

DriftError ComputeFinalError(const std::vector<Rigid3d>& ground_truth,
                             const std::vector<Rigid3d>& estimate, VehicleFrame frame) {
  CHECK_EQ(ground_truth.size(), estimate.size());
  CHECK(!estimate.empty());
  return ComputeDriftError({ground_truth.front(), ground_truth.back()},
                           {estimate.front(), estimate.back()}, frame);
}

}  // namespace semantic_kiss::evaluation
