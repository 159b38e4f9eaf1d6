// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_SUBMAP_BOUNDS_H_
#define CARTOGRAPHER_IO_SUBMAP_BOUNDS_H_

#include <Eigen/Geometry>

#include "cartographer/submap/semantic_grid.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

// A box around the hits of a submap, in the map as seen from above [m]; empty if there are none.
Eigen::AlignedBox2d BoundsInMap(const submap::SemanticGrid& grid,
                                const transform::Rigid3d& map_from_submap);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_SUBMAP_BOUNDS_H_
