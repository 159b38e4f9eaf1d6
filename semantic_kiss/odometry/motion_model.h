// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_MOTION_MODEL_H_
#define SEMANTIC_KISS_ODOMETRY_MOTION_MODEL_H_

#include "cartographer/transform/se3.h"

namespace semantic_kiss::odometry {

// Constant velocity: the next scan moves as the last one did. Where a scan could not be placed its
// prediction is observed in its stead, and the model simply carries on.
class MotionModel {
 public:
  const cartographer::transform::Rigid3d& local_from_last() const { return local_from_last_; }

  // Predicted pose of the next scan.
  cartographer::transform::Rigid3d Predict() const { return local_from_last_ * last_from_next_; }

  // Twist of the motion from one scan to the next, in the sensor's frame.
  cartographer::transform::Twist Motion() const {
    return cartographer::transform::Log(last_from_next_);
  }

  void Observe(const cartographer::transform::Rigid3d& local_from_sensor) {
    last_from_next_ = local_from_last_.inverse() * local_from_sensor;
    local_from_last_ = local_from_sensor;
  }

 private:
  cartographer::transform::Rigid3d local_from_last_;
  cartographer::transform::Rigid3d last_from_next_;
};

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_MOTION_MODEL_H_
