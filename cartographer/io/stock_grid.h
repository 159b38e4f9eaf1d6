// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_STOCK_GRID_H_
#define CARTOGRAPHER_IO_STOCK_GRID_H_

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/mapping/proto/grid_2d.pb.h"
#include "cartographer/sensor/label.h"
#include "cartographer/submap/semantic_grid.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

// Between the multi-layer grid and the grid of stock Cartographer: dense, one probability of being
// occupied a cell, axes along those of the trajectory's local frame (not the submap's).

// Projects the layers, so that stock Cartographer can open our maps. A cell with h hits of its
// dominant label has
//   P(occupied) = 1 / (1 + (9/11)^h)    if the label has no ground role (each hit multiplies the
//                                       odds by 11/9, as a hit of P = 0.55 does),
//   P(occupied) = 1 / (1 + (11/9)^h)    if it has,
// clamped to [0.1, 0.9], and is stored as 1 + round((1 - P - 0.1) / 0.8 * 32766); 0 means no hits.
// Where the submap's heading is not along the local axes, cells take the value under their centre,
// and each occupied cell also marks the cell that its own centre falls into: nothing occupied
// vanishes. Error: a box of hits of over 2e7 cells, whose record would be too large.
absl::StatusOr<mapping::proto::Grid2D> ToStockGrid(const submap::SemanticGrid& grid,
                                                   const sensor::LabelMask& ground,
                                                   const transform::Rigid3d& local_from_submap);

// The error that ToStockGrid() would have, at a small share of its time.
absl::Status CheckFitsStockGrid(const submap::SemanticGrid& grid,
                                const transform::Rigid3d& local_from_submap);

// The reverse, as far as it goes: cells with P(occupied) > 0.5 become hits of kUnlabeled, by the
// formula above solved for h (at least 1), in the cell of the submap's grid that holds the cell's
// centre (an offset of up to half a cell). Free space is not kept: layers hold hits alone.
// kUnimplemented for TSDF grids; kDataLoss for limits, counts and values that do not fit together,
// and for hits in 2^19 tiles or more (256 MiB).
absl::StatusOr<submap::SemanticGrid> FromStockGrid(const mapping::proto::Grid2D& proto,
                                                   const transform::Rigid3d& local_from_submap);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_STOCK_GRID_H_
