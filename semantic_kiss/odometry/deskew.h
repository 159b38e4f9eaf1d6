// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_DESKEW_H_
#define SEMANTIC_KISS_ODOMETRY_DESKEW_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cartographer/transform/se3.h"

namespace semantic_kiss::odometry {

// Undoes the sensor's motion during a sweep by the constant-velocity model: a point taken at the
// fraction s of the sweep (0: first, 1: last point) moves by Exp((s - 1) * motion) into the
// sensor's frame at the end of the sweep. Source: KISS-ICP, section III-A.
//
// Exp is evaluated at kNumKnots instants and its matrix interpolated between them: for 2 m and
// 0.1 rad within a sweep that is exact to 0.04 mm at 100 m.
class SweepMotion {
 public:
  // `times` [s] of the points of one scan, in any order and on any common scale. There is nothing
  // to undo, hence nullopt, if none of `times` is finite, or if those that are lie within 1e-6 s.
  // `motion`: Log(sensor-at-start from sensor-at-end of the sweep).
  static std::optional<SweepMotion> Create(const std::vector<float>& times,
                                           const cartographer::transform::Twist& motion);

  // Moves a point taken at `time` to where it would have been seen at the end of the sweep. A time
  // that is not finite counts as the end: the point stays.
  Eigen::Vector3f ToSweepEnd(const Eigen::Vector3f& position, float time) const;

 private:
  static constexpr int kNumKnots = 65;
  using Matrix34f = Eigen::Matrix<float, 3, 4>;

  SweepMotion(float first_time, float last_time, const cartographer::transform::Twist& motion);

  float first_time_;
  float knots_per_second_;
  std::vector<Matrix34f> end_from_knot_;
};

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_DESKEW_H_
