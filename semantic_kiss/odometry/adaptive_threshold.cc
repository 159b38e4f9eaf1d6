// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/adaptive_threshold.h"

#include <cmath>

namespace semantic_kiss::odometry {

AdaptiveThreshold::AdaptiveThreshold(const proto::AdaptiveThresholdOptions& options,
                                     double max_range_m)
    : options_(options),
      max_range_m_(max_range_m),
      sum_of_squares_(options.initial_samples() * options.initial_m() * options.initial_m()),
      num_samples_(options.initial_samples()) {}

double AdaptiveThreshold::Sigma() const {
  return num_samples_ == 0 ? options_.initial_m() : std::sqrt(sum_of_squares_ / num_samples_);
}

double AdaptiveThreshold::Gate() const { return options_.gate_sigmas() * Sigma(); }

double AdaptiveThreshold::KernelScale() const { return options_.kernel_sigmas() * Sigma(); }

void AdaptiveThreshold::Observe(const cartographer::transform::Rigid3d& predicted_from_actual,
                                double from_start_m) {
  const double error = ModelError(predicted_from_actual, max_range_m_);
  if (error <= options_.min_model_error_m() || from_start_m < options_.learn_beyond_m()) return;
  sum_of_squares_ += error * error;
  ++num_samples_;
}

double ModelError(const cartographer::transform::Rigid3d& predicted_from_actual,
                  double max_range_m) {
  const double angle = cartographer::transform::RotationAngle(predicted_from_actual);
  return predicted_from_actual.translation().norm() + 2. * max_range_m * std::sin(angle / 2.);
}

}  // namespace semantic_kiss::odometry
