// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/placed.h"

namespace cartographer::submap {

Eigen::Isometry2d MapFromGrid(const PlacedSubmap& placed) {
  Eigen::Isometry2d map_from_grid = Eigen::Isometry2d::Identity();
  map_from_grid.translate(placed.map_from_submap.translation().head<2>());
  map_from_grid.rotate(transform::Yaw(placed.map_from_submap.rotation()));
  return map_from_grid;
}

}  // namespace cartographer::submap
