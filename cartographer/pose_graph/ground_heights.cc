// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/ground_heights.h"

#include "glog/logging.h"

namespace cartographer::pose_graph {

GroundHeights::GroundHeights(double cell_m) : inverse_cell_(1. / cell_m) { CHECK_GT(cell_m, 0.); }

registration::VoxelKey GroundHeights::KeyAt(const Eigen::Vector2d& position) const {
  return registration::KeyOf(
      registration::VoxelOf({position.x(), position.y(), 0.}, inverse_cell_));
}

void GroundHeights::Add(const sensor::LabeledPointCloud& cloud,
                        const transform::Rigid3d& target_from_cloud,
                        const sensor::LabelMask& ground) {
  const Eigen::Matrix3d rotation = target_from_cloud.rotation().toRotationMatrix();
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!ground.Contains(cloud.labels[i])) continue;
    const Eigen::Vector3d point =
        rotation * cloud.positions[i].cast<double>() + target_from_cloud.translation();
    const auto next = static_cast<uint32_t>(cells_.size());
    const uint32_t found = index_.FindOrInsert(KeyAt(point.head<2>()), next);
    if (found == registration::VoxelIndex::kNone) cells_.emplace_back();
    Cell& cell = found == registration::VoxelIndex::kNone ? cells_.back() : cells_[found];
    cell.sum_m += point.z();
    ++cell.count;
  }
}

std::optional<double> GroundHeights::At(const Eigen::Vector2d& position) const {
  const uint32_t found = index_.Find(KeyAt(position));
  if (found == registration::VoxelIndex::kNone) return std::nullopt;
  return cells_[found].sum_m / cells_[found].count;
}

}  // namespace cartographer::pose_graph
