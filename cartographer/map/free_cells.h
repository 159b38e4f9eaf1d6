// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_FREE_CELLS_H_
#define CARTOGRAPHER_MAP_FREE_CELLS_H_

#include <cstdint>
#include <vector>

#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::map {

// What one visit saw in a square of cells: hits of ground labels, and of what may stand on it.
// Square and cells are in the map frame.
class VisitedSquare {
 public:
  // Covers [min, min + side) along both axes, and asks for hits that lie `reach` cells further out.
  VisitedSquare(const submap::CellIndex& min, int side, int reach);

  // Hits of cells that are too far out count for nothing.
  void AddGround(const submap::CellIndex& cell, int hits) { Add(cell, hits, &ground_); }
  void AddStanding(const submap::CellIndex& cell, int hits) { Add(cell, hits, &standing_); }

  // The cells of the square, row by row, that are free: around which, `reach` cells to all sides,
  // the ground was hit at least `min_ground_hits` times, and what may stand on it at most
  // `max_movable_share` times as often. A ray that ends on the ground has passed what is above it.
  std::vector<bool> FreeCells(const proto::TransientOptions& options) const;

 private:
  void Add(const submap::CellIndex& cell, int hits, std::vector<uint32_t>* layer);
  std::vector<uint64_t> SumsWithinReach(const std::vector<uint32_t>& layer) const;

  const int side_, reach_;
  const int width_;              // with what lies within reach outside
  const submap::CellIndex min_;  // of that
  std::vector<uint32_t> ground_, standing_;
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_FREE_CELLS_H_
