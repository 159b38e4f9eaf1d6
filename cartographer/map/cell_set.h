// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_CELL_SET_H_
#define CARTOGRAPHER_MAP_CELL_SET_H_

#include <bitset>
#include <map>

#include "cartographer/submap/semantic_grid.h"

namespace cartographer::map {

// A set of a grid's cells, compact where they lie together.
class CellSet {
 public:
  void Insert(const submap::CellIndex& cell) {
    const Place place = PlaceOf(cell);
    tiles_[place.tile].set(place.bit);
  }
  bool Contains(const submap::CellIndex& cell) const {
    const Place place = PlaceOf(cell);
    const auto tile = tiles_.find(place.tile);
    return tile != tiles_.end() && tile->second[place.bit];
  }
  bool Empty() const { return tiles_.empty(); }

 private:
  static constexpr int kSize = submap::SemanticGrid::kTileSize;
  struct Place {
    submap::SemanticGrid::TileIndex tile;
    int bit;
  };
  static Place PlaceOf(const submap::CellIndex& cell) {
    const auto tile_of = [](int i) { return (i >= 0 ? i : i - kSize + 1) / kSize; };
    const int x = tile_of(cell.x()), y = tile_of(cell.y());
    return {{x, y}, (cell.y() - y * kSize) * kSize + cell.x() - x * kSize};
  }

  std::map<submap::SemanticGrid::TileIndex, std::bitset<kSize * kSize>> tiles_;
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_CELL_SET_H_
