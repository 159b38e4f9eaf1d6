// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_GROUND_HEIGHTS_H_
#define CARTOGRAPHER_POSE_GRAPH_GROUND_HEIGHTS_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cartographer/registration/voxel_index.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// How high the ground lies, by squares of the x-y plane: the mean height of the points with a
// ground label.
class GroundHeights {
 public:
  // `cell_m` is the side of a square, > 0 (CHECKed).
  explicit GroundHeights(double cell_m);

  // Adds the points whose label is in `ground`.
  void Add(const sensor::LabeledPointCloud& cloud, const transform::Rigid3d& target_from_cloud,
           const sensor::LabelMask& ground);

  // Height [m] of the ground at a position; nullopt where no ground was seen.
  std::optional<double> At(const Eigen::Vector2d& position) const;

  size_t num_cells() const { return cells_.size(); }

 private:
  struct Cell {
    double sum_m = 0.;
    int count = 0;
  };
  registration::VoxelKey KeyAt(const Eigen::Vector2d& position) const;

  double inverse_cell_;
  registration::VoxelIndex index_;  // into cells_
  std::vector<Cell> cells_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_GROUND_HEIGHTS_H_
