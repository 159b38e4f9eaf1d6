// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_PLACED_H_
#define CARTOGRAPHER_SUBMAP_PLACED_H_

#include <Eigen/Geometry>
#include <memory>

#include "cartographer/common/time.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/submap.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::submap {

// A submap placed in the map.
struct PlacedSubmap {
  transform::Rigid3d map_from_submap;
  std::shared_ptr<const Submap> submap;
};

// Where its grid lies in the map seen from above; the pose's roll and pitch are ignored, as in
// pictures.
Eigen::Isometry2d MapFromGrid(const PlacedSubmap& placed);

// A node, a scan that went into submaps, placed in the map.
struct PlacedNode {
  common::Time time;
  transform::Rigid3d map_from_node;    // after optimization
  transform::Rigid3d local_from_node;  // as the odometry had it
  // Sub-sampled scan, in the node's (sensor's) frame. Never null; may be empty.
  std::shared_ptr<const sensor::LabeledPointCloud> cloud;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_PLACED_H_
