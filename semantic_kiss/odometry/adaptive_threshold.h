// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_ADAPTIVE_THRESHOLD_H_
#define SEMANTIC_KISS_ODOMETRY_ADAPTIVE_THRESHOLD_H_

#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss::odometry {

// Learns how far off the motion model's predictions are. sigma is the root mean square of the
// model errors seen so far, the initial value counting as the first one (or as several, or, as in
// SAGE-ICP, as none once there are others); errors under `min_model_error_m` are left out. Source:
// KISS-ICP, section III-C.
class AdaptiveThreshold {
 public:
  // `max_range_m`: where a rotation's error is felt.
  AdaptiveThreshold(const proto::AdaptiveThresholdOptions& options, double max_range_m);

  double Sigma() const;  // [m]
  double Gate() const;   // largest distance of a pair [m]
  // Scale of the kernel that weighs pairs: a multiple of sigma, although kernels take it for m^2
  // (normal_equations.h).
  double KernelScale() const;

  // `predicted_from_actual`: the pose that was found, in the frame of the predicted pose;
  // `from_start_m`: how far that is from the first pose.
  void Observe(const cartographer::transform::Rigid3d& predicted_from_actual, double from_start_m);

 private:
  const proto::AdaptiveThresholdOptions options_;
  const double max_range_m_;
  double sum_of_squares_;
  int num_samples_;
};

// How far [m] a pose error moves points at most: |t| + 2 * max_range * sin(angle / 2).
double ModelError(const cartographer::transform::Rigid3d& predicted_from_actual,
                  double max_range_m);

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_ADAPTIVE_THRESHOLD_H_
