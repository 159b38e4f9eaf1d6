// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/submap_bounds.h"

namespace cartographer::io {

Eigen::AlignedBox2d BoundsInMap(const submap::SemanticGrid& grid,
                                const transform::Rigid3d& map_from_submap) {
  Eigen::AlignedBox2d bounds;
  const submap::SemanticGrid::CellBox box = grid.Bounds();
  if (box.Empty()) return bounds;
  for (const int x : {box.min.x(), box.max.x()}) {
    for (const int y : {box.min.y(), box.max.y()}) {
      const Eigen::Vector3d corner =
          map_from_submap * (grid.resolution_m() * Eigen::Vector3d(x, y, 0.));
      bounds.extend(corner.head<2>());
    }
  }
  return bounds;
}

}  // namespace cartographer::io
