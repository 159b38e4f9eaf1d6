// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/motion_filter.h"

#include <cmath>

namespace cartographer::slam {

bool MotionFilter::Admit(common::Time time, const transform::Rigid3d& local_from_sensor) {
  if (has_last_) {
    const transform::Rigid3d last_from_sensor = local_from_last_.inverse() * local_from_sensor;
    const double angle_deg = transform::RotationAngle(last_from_sensor) * 180. / M_PI;
    if (common::ToSeconds(time - last_time_) <= options_.max_time_s() &&
        last_from_sensor.translation().norm() <= options_.max_distance_m() &&
        angle_deg <= options_.max_angle_deg()) {
      return false;
    }
  }
  has_last_ = true;
  last_time_ = time;
  local_from_last_ = local_from_sensor;
  return true;
}

}  // namespace cartographer::slam
