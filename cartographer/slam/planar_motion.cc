// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/planar_motion.h"

#include <cmath>

#include "glog/logging.h"

namespace cartographer::slam {

using scan_matching::PlanarPose;

PlanarPose PlanarMotion::Predict(common::Time time) const {
  if (num_observed_ == 0) return {};
  const double seconds = common::ToSeconds(time - last_time_);
  const Eigen::Rotation2Dd local_from_last(local_from_last_.yaw_rad);
  return {local_from_last_.translation + local_from_last * (seconds * translation_m_per_s_),
          std::remainder(local_from_last_.yaw_rad + seconds * yaw_rad_per_s_, 2. * M_PI)};
}

void PlanarMotion::Observe(common::Time time, const PlanarPose& local_from_sensor) {
  if (num_observed_++ > 0) {
    const double seconds = common::ToSeconds(time - last_time_);
    CHECK_GT(seconds, 0.);
    const Eigen::Rotation2Dd last_from_local(-local_from_last_.yaw_rad);
    const double turned_rad =
        std::remainder(local_from_sensor.yaw_rad - local_from_last_.yaw_rad, 2. * M_PI);
    // In the new pose's frame, for it turns with the sensor.
    translation_m_per_s_ =
        last_from_local * (local_from_sensor.translation - local_from_last_.translation) / seconds;
    yaw_rad_per_s_ = turned_rad / seconds;
  }
  last_time_ = time;
  local_from_last_ = local_from_sensor;
}

}  // namespace cartographer::slam
