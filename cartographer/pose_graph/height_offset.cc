// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/height_offset.h"

#include <algorithm>
#include <vector>

namespace cartographer::pose_graph {

std::optional<HeightOffset> FindHeightOffset(const sensor::LabeledPointCloud& cloud,
                                             const transform::Rigid3d& target_from_node,
                                             const GroundHeights& target,
                                             const sensor::LabelMask& ground,
                                             const proto::GroundOptions& options) {
  const Eigen::Matrix3d rotation = target_from_node.rotation().toRotationMatrix();
  const double max_squared_range = options.max_range_m() * options.max_range_m();
  std::vector<double> offsets;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!ground.Contains(cloud.labels[i])) continue;
    if (cloud.positions[i].squaredNorm() > max_squared_range) continue;
    const Eigen::Vector3d point =
        rotation * cloud.positions[i].cast<double>() + target_from_node.translation();
    const std::optional<double> height = target.At(point.head<2>());
    if (height.has_value()) offsets.push_back(*height - point.z());
  }
  if (offsets.size() < static_cast<size_t>(std::max(1, options.min_points()))) return std::nullopt;
  const auto median = offsets.begin() + offsets.size() / 2;
  std::nth_element(offsets.begin(), median, offsets.end());
  return HeightOffset{*median, static_cast<int>(offsets.size())};
}

}  // namespace cartographer::pose_graph
