// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_PLANAR_MOTION_H_
#define CARTOGRAPHER_SLAM_PLANAR_MOTION_H_

#include "cartographer/common/time.h"
#include "cartographer/scan_matching/planar_pose.h"

namespace cartographer::slam {

// Constant velocity in the plane: the sensor goes on as it went from the last scan but one to the
// last.
class PlanarMotion {
 public:
  // The pose at a time after the last one observed; identity before the first.
  scan_matching::PlanarPose Predict(common::Time time) const;

  // Whether there is a velocity: two scans were observed.
  bool IsKnown() const { return num_observed_ >= 2; }

  // Times must increase (CHECKed).
  void Observe(common::Time time, const scan_matching::PlanarPose& local_from_sensor);

 private:
  int num_observed_ = 0;
  common::Time last_time_;
  scan_matching::PlanarPose local_from_last_;
  // Velocity in the last pose's frame.
  Eigen::Vector2d translation_m_per_s_ = Eigen::Vector2d::Zero();
  double yaw_rad_per_s_ = 0.;
};

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_PLANAR_MOTION_H_
