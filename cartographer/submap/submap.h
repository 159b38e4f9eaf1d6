// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_SUBMAP_H_
#define CARTOGRAPHER_SUBMAP_SUBMAP_H_

#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/semantic_grid.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::submap {

// About a second of scans, fused: the multi-layer grid for search, a sparse labeled cloud for
// refinement in space and for export. Both are in the submap's frame, which is level (z up along
// gravity) and whose origin is the pose of the first scan.
struct Submap {
  explicit Submap(double resolution_m) : grid(resolution_m) {}

  transform::Rigid3d local_from_submap;
  SemanticGrid grid;
  sensor::LabeledPointCloud cloud;  // [m], submap frame; complete once `finished`
  int num_scans = 0;
  bool finished = false;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_SUBMAP_H_
