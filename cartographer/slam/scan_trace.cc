// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/scan_trace.h"

#include <cmath>

#include "absl/strings/str_format.h"

namespace cartographer::slam {
namespace {

constexpr double kDegrees = 180. / M_PI;

}  // namespace

PointsByLabel CountByLabel(const sensor::LabeledPointCloud& cloud) {
  PointsByLabel counts;
  for (const sensor::Label label : cloud.labels) ++counts[label];
  return counts;
}

TraceStep& TraceStep::Takes(const std::string& step, size_t num_points) {
  from = step;
  points_in = num_points;
  return *this;
}

TraceStep& TraceStep::Gives(size_t num_points) {
  points_out = num_points;
  return *this;
}

TraceStep& TraceStep::Gives(const sensor::LabeledPointCloud& cloud) {
  labels = CountByLabel(cloud);
  return Gives(cloud.size());
}

TraceStep& TraceStep::Took(double duration_s) {
  seconds = duration_s;
  return *this;
}

std::string PoseText(const transform::Rigid3d& pose) {
  const Eigen::Vector3d& position = pose.translation();
  return absl::StrFormat("x %.2f, y %.2f, z %.2f m, yaw %.1f deg", position.x(), position.y(),
                         position.z(), transform::Yaw(pose.rotation()) * kDegrees);
}

std::string MotionText(const transform::Rigid3d& motion) {
  return absl::StrFormat("%.3f m, %.3f deg", motion.translation().norm(),
                         transform::RotationAngle(motion) * kDegrees);
}

}  // namespace cartographer::slam
