// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_FREE_CELLS_H_
#define CARTOGRAPHER_MAP_FREE_CELLS_H_

#include <bitset>
#include <map>

#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/sensor/label.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::map {

// Where a submap saw the ground and nothing on it: the cells around which, as far as `tolerance_m`
// of the options reaches along both axes, the ground was hit at least `min_ground_hits` times, and
// the labels in `standing` at most `max_movable_share` times as often. A ray that ends on the
// ground has passed all that is above it.
class FreeCells {
 public:
  FreeCells(const submap::SemanticGrid& grid, const sensor::LabelMask& ground,
            const sensor::LabelMask& standing, const proto::TransientOptions& options);

  bool Contains(const submap::CellIndex& cell) const;

 private:
  using TileIndex = submap::SemanticGrid::TileIndex;
  static constexpr int kTileSize = submap::SemanticGrid::kTileSize;

  std::map<TileIndex, std::bitset<kTileSize * kTileSize>> tiles_;
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_FREE_CELLS_H_
