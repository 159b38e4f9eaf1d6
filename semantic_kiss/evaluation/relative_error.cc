// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/relative_error.h"

#include <algorithm>
#include <cmath>

#include "glog/logging.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

// Errors of one segment, or a sum of such.
struct ErrorSum {
  double translation = 0.;   // m per m
  double rotation_rad = 0.;  // per m
  int num_segments = 0;

  void operator+=(const ErrorSum& other) {
    translation += other.translation;
    rotation_rad += other.rotation_rad;
    num_segments += other.num_segments;
  }
  RelativeError Mean() const {
    if (num_segments == 0) return {};
    return {100. * translation / num_segments, rotation_rad / num_segments * 180. / M_PI,
            num_segments};
  }
};

ErrorSum ErrorOfSegments(const std::vector<Rigid3d>& ground_truth,
                         const std::vector<Rigid3d>& estimate,
                         const std::vector<double>& distances_m, double length_m) {
  ErrorSum sum;
  for (size_t first = 0; first < ground_truth.size(); first += kSegmentStep) {
    const auto end = std::upper_bound(distances_m.begin() + first, distances_m.end(),
                                      distances_m[first] + length_m);
    if (end == distances_m.end()) break;  // later starts end later still
    const size_t last = end - distances_m.begin();
    const Rigid3d true_motion = ground_truth[first].inverse() * ground_truth[last];
    const Rigid3d motion = estimate[first].inverse() * estimate[last];
    const Rigid3d error = motion.inverse() * true_motion;
    sum += {error.translation().norm() / length_m,
            cartographer::transform::RotationAngle(error) / length_m, 1};
  }
  return sum;
}

}  // namespace

std::vector<double> DrivenDistances(const std::vector<Rigid3d>& poses) {
  std::vector<double> distances_m;
  distances_m.reserve(poses.size());
  for (size_t i = 0; i < poses.size(); ++i) {
    distances_m.push_back(
        i == 0 ? 0.
               : distances_m.back() + (poses[i].translation() - poses[i - 1].translation()).norm());
  }
  return distances_m;
}

std::optional<RelativeErrors> ComputeRelativeErrors(const std::vector<Rigid3d>& ground_truth,
                                                    const std::vector<Rigid3d>& estimate) {
  CHECK_EQ(ground_truth.size(), estimate.size());
  for (size_t i = 0; i < estimate.size(); ++i) {
    CHECK(ground_truth[i].IsFinite() && estimate[i].IsFinite()) << "pose " << i;
  }
  const std::vector<double> distances_m = DrivenDistances(ground_truth);
  RelativeErrors errors;
  ErrorSum overall;
  for (const double length_m : kSegmentLengths_m) {
    const ErrorSum sum = ErrorOfSegments(ground_truth, estimate, distances_m, length_m);
    errors.by_length.push_back({length_m, sum.Mean()});
    overall += sum;
  }
  if (overall.num_segments == 0) return std::nullopt;
  errors.overall = overall.Mean();
  return errors;
}

}  // namespace semantic_kiss::evaluation
