// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/free_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace cartographer::map {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;
using TileIndex = SemanticGrid::TileIndex;

constexpr int kSize = SemanticGrid::kTileSize;

// Hits of several labels, summed.
class HitSums {
 public:
  HitSums(const SemanticGrid& grid, const sensor::LabelMask& labels, int reach)
      : reach_(reach), tiles_of_reach_((reach + kSize - 1) / kSize) {
    for (const sensor::Label label : grid.Labels()) {
      if (!labels.Contains(label)) continue;
      for (const auto& [index, tile] : grid.LayerOf(label)) {
        Tile& sums = tiles_[index];
        for (size_t i = 0; i < sums.size(); ++i) sums[i] += tile->hits[i];
      }
    }
  }

  // The tiles with a cell from which less than the reach leads to a hit, and some more.
  std::set<TileIndex> TilesInReach() const {
    std::set<TileIndex> result;
    for (const auto& [index, sums] : tiles_) {
      ForEachNeighbor(index, [&](const TileIndex& near) { result.insert(near); });
    }
    return result;
  }

  // Sums over the squares of 2 * reach + 1 cells around each cell of a tile, row by row.
  std::vector<uint64_t> SquareSums(const TileIndex& index) const {
    const int width = kSize + 2 * reach_, stride = width + 1, side = 2 * reach_ + 1;
    const std::vector<uint64_t> integral = Integral(Window(index), width);
    std::vector<uint64_t> sums;
    sums.reserve(kSize * kSize);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const uint64_t* const lower = &integral[y * stride + x];
        const uint64_t* const upper = lower + side * stride;
        sums.push_back(upper[side] - upper[0] - lower[side] + lower[0]);
      }
    }
    return sums;
  }

 private:
  using Tile = std::array<uint32_t, kSize * kSize>;

  template <typename Body>
  void ForEachNeighbor(const TileIndex& index, const Body& body) const {
    for (int y = -tiles_of_reach_; y <= tiles_of_reach_; ++y) {
      for (int x = -tiles_of_reach_; x <= tiles_of_reach_; ++x) {
        body(TileIndex{index.x + x, index.y + y});
      }
    }
  }

  // The hits of a tile and of all around it that the reach covers, row by row.
  std::vector<uint32_t> Window(const TileIndex& index) const {
    const int width = kSize + 2 * reach_;
    std::vector<uint32_t> window(width * width);
    ForEachNeighbor(index, [&](const TileIndex& near) {
      const auto tile = tiles_.find(near);
      if (tile == tiles_.end()) return;
      const int left = (near.x - index.x) * kSize + reach_;
      const int top = (near.y - index.y) * kSize + reach_;
      for (int y = std::max(0, -top); y < std::min(kSize, width - top); ++y) {
        for (int x = std::max(0, -left); x < std::min(kSize, width - left); ++x) {
          window[(top + y) * width + left + x] = tile->second[y * kSize + x];
        }
      }
    });
    return window;
  }

  // integral[y * (width + 1) + x] is the sum over all cells left of x in the rows before y.
  static std::vector<uint64_t> Integral(const std::vector<uint32_t>& window, int width) {
    const int stride = width + 1;
    std::vector<uint64_t> integral(stride * stride);
    for (int y = 0; y < width; ++y) {
      uint64_t row_sum = 0;
      for (int x = 0; x < width; ++x) {
        row_sum += window[y * width + x];
        integral[(y + 1) * stride + x + 1] = integral[y * stride + x + 1] + row_sum;
      }
    }
    return integral;
  }

  const int reach_;           // [cells]
  const int tiles_of_reach_;  // that it may touch on either side of a tile
  std::map<TileIndex, Tile> tiles_;
};

}  // namespace

FreeCells::FreeCells(const SemanticGrid& grid, const sensor::LabelMask& ground,
                     const sensor::LabelMask& standing, const proto::TransientOptions& options) {
  const int reach = static_cast<int>(std::lround(options.tolerance_m() / grid.resolution_m()));
  const HitSums ground_sums(grid, ground, reach), standing_sums(grid, standing, reach);
  for (const TileIndex& index : ground_sums.TilesInReach()) {
    const std::vector<uint64_t> ground_hits = ground_sums.SquareSums(index);
    const std::vector<uint64_t> standing_hits = standing_sums.SquareSums(index);
    std::bitset<kSize * kSize> free;
    for (size_t i = 0; i < ground_hits.size(); ++i) {
      const auto seen = static_cast<double>(ground_hits[i]);
      free[i] = seen >= options.min_ground_hits() &&
                static_cast<double>(standing_hits[i]) <= options.max_movable_share() * seen;
    }
    if (free.any()) tiles_.emplace(index, free);
  }
}

bool FreeCells::Contains(const CellIndex& cell) const {
  const auto floor_quotient = [](int value) {
    return (value >= 0 ? value : value - kSize + 1) / kSize;
  };
  const TileIndex index{floor_quotient(cell.x()), floor_quotient(cell.y())};
  const auto tile = tiles_.find(index);
  if (tile == tiles_.end()) return false;
  return tile->second[(cell.y() - index.y * kSize) * kSize + cell.x() - index.x * kSize];
}

}  // namespace cartographer::map
