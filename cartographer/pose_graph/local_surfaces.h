// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_LOCAL_SURFACES_H_
#define CARTOGRAPHER_POSE_GRAPH_LOCAL_SURFACES_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/registration/voxel_index.h"
#include "cartographer/sensor/labeled_point_cloud.h"

namespace cartographer::pose_graph {

// What the shape of a cloud around a place tells of a point there: a wall holds it across, not
// along; a pole holds it across in two directions; in a bush nothing holds it.
//
// Space is cut into voxels. With the variances l_1 <= l_2 <= l_3 of the points of a voxel along
// their principal axes e_i and the variance s^2 of a point from its surface, a point that was
// matched there is known with the information
//
//   sum_i (1 / (l_i + s^2) - 1 / (l_3 + s^2)) e_i e_i^T   [1 / m^2]:
//
// along the axis of the largest spread, points lie where the lidar happened to hit.
class LocalSurfaces {
 public:
  // Frame of `cloud`; both numbers in m and > 0 (CHECKed).
  LocalSurfaces(const sensor::LabeledPointCloud& cloud, double voxel_size_m, double point_sigma_m);

  // The information at a place; zero where there are too few points to have a shape.
  Eigen::Matrix3d InformationAt(const Eigen::Vector3d& position) const;

  size_t num_voxels() const { return information_.size(); }

 private:
  double inverse_voxel_size_;
  registration::VoxelIndex index_;  // into information_
  std::vector<Eigen::Matrix3f> information_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_LOCAL_SURFACES_H_
