// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/deskew.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace semantic_kiss::odometry {
namespace {

// No sensor turns faster, so that what is shorter is rounding.
constexpr float kShortestSweep_s = 1e-6f;

}  // namespace

std::optional<SweepMotion> SweepMotion::Create(const std::vector<float>& times,
                                               const cartographer::transform::Twist& motion) {
  float first = std::numeric_limits<float>::infinity();
  float last = -first;
  for (const float time : times) {
    if (!std::isfinite(time)) continue;
    first = std::min(first, time);
    last = std::max(last, time);
  }
  const float sweep_s = last - first;
  if (!(sweep_s >= kShortestSweep_s) || !std::isfinite(sweep_s)) return std::nullopt;
  return SweepMotion(first, last, motion);
}

SweepMotion::SweepMotion(float first_time, float last_time,
                         const cartographer::transform::Twist& motion)
    : first_time_(first_time), knots_per_second_((kNumKnots - 1) / (last_time - first_time)) {
  end_from_knot_.reserve(kNumKnots);
  for (int knot = 0; knot < kNumKnots; ++knot) {
    const double fraction = static_cast<double>(knot) / (kNumKnots - 1);
    end_from_knot_.push_back(
        cartographer::transform::Exp((fraction - 1.) * motion).Matrix().cast<float>());
  }
}

Eigen::Vector3f SweepMotion::ToSweepEnd(const Eigen::Vector3f& position, float time) const {
  if (!std::isfinite(time)) return position;
  const float at = (time - first_time_) * knots_per_second_;
  const int knot = std::clamp(static_cast<int>(at), 0, kNumKnots - 2);
  const float weight = at - knot;
  const Matrix34f matrix =
      (1.f - weight) * end_from_knot_[knot] + weight * end_from_knot_[knot + 1];
  return matrix.leftCols<3>() * position + matrix.col(3);
}

}  // namespace semantic_kiss::odometry
