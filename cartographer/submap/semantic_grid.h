// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_SEMANTIC_GRID_H_
#define CARTOGRAPHER_SUBMAP_SEMANTIC_GRID_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::submap {

// Index of a cell in the x-y plane of the submap's frame: cell (x, y) covers
// [x, x + 1) * resolution by [y, y + 1) * resolution.
using CellIndex = Eigen::Array2i;

// The multi-layer grid of the paper: for every label one layer of hit counts. A point adds one hit
// to its label's layer in the cell below or above it; nothing is ray-cast, no ground is filtered.
//
// Layers are sparse: a layer holds square tiles of kTileSize x kTileSize cells, and only those that
// were hit. Counts saturate at kMaxHits.
class SemanticGrid {
 public:
  static constexpr int kTileSize = 16;
  static constexpr int kMaxHits = 65535;

  // Row-major: cell (x, y) of a tile is hits[y * kTileSize + x].
  struct Tile {
    std::array<uint16_t, kTileSize * kTileSize> hits{};
  };
  // Tiles by their index: tile (x, y) covers the cells [x * kTileSize, (x + 1) * kTileSize) x ...
  // Ordered by (y, x), so that walking a layer is deterministic.
  struct TileIndex {
    int x = 0, y = 0;
    friend bool operator<(const TileIndex& a, const TileIndex& b) {
      return a.y != b.y ? a.y < b.y : a.x < b.x;
    }
    friend bool operator==(const TileIndex& a, const TileIndex& b) {
      return a.x == b.x && a.y == b.y;
    }
  };
  using Layer = std::map<TileIndex, const Tile*>;

  // A cell seen over all layers: the label with the most hits (the smaller label on ties;
  // kUnlabeled only where no other label was hit) and its hits; 0 hits: nothing was ever seen here.
  struct DominantLabel {
    sensor::Label label = sensor::kUnlabeled;
    int hits = 0;
  };

  // Half-open box of cells: min <= cell < max. Empty: min == max.
  struct CellBox {
    CellIndex min{0, 0};
    CellIndex max{0, 0};
    bool Empty() const { return (min >= max).any(); }
  };

  // `resolution_m` is the side of a cell, > 0 (CHECKed).
  explicit SemanticGrid(double resolution_m);

  double resolution_m() const { return resolution_m_; }

  CellIndex CellOf(const Eigen::Vector2f& position) const {
    return {FloorToInt(position.x() * inverse_resolution_),
            FloorToInt(position.y() * inverse_resolution_)};
  }
  Eigen::Vector2d CenterOf(const CellIndex& cell) const {
    return (cell.cast<double>() + 0.5).matrix() * resolution_m_;
  }

  // Adds `hits` (> 0) to a cell of a layer.
  void AddHits(sensor::Label label, const CellIndex& cell, int hits = 1);
  // Adds a hit for every point, but for those whose label is in `dropped`. `grid_from_cloud` places
  // the cloud; heights play no part.
  void AddCloud(const sensor::LabeledPointCloud& cloud, const transform::Rigid3d& grid_from_cloud,
                const sensor::LabelMask& dropped);
  int Hits(sensor::Label label, const CellIndex& cell) const;
  DominantLabel Dominant(const CellIndex& cell) const;

  // Labels that have at least one tile, ascending.
  std::vector<sensor::Label> Labels() const;
  // The tiles of a layer in order; pointers are valid until the grid changes.
  Layer LayerOf(sensor::Label label) const;
  // All tiles that any layer has, with the dominant label of each cell: what pictures, projections
  // and scores walk over.
  struct DominantTile {
    std::array<sensor::Label, kTileSize * kTileSize> labels{};
    std::array<uint16_t, kTileSize * kTileSize> hits{};
  };
  std::map<TileIndex, DominantTile> DominantTiles() const;

  // Replaces a whole tile: how readers of files fill a grid.
  void SetTile(sensor::Label label, const TileIndex& index, const Tile& tile);
  // Removes all layers whose label is in `mask`.
  void RemoveLayers(const sensor::LabelMask& mask);

  // The smallest box of tiles that contains all hits (edges fall on tile borders).
  CellBox Bounds() const;
  size_t num_tiles() const { return tiles_.size(); }

 private:
  // std::floor without the library call that it costs on plain x86-64.
  static int FloorToInt(float value) {
    const int truncated = static_cast<int>(value);
    return truncated - (value < static_cast<float>(truncated) ? 1 : 0);
  }
  static uint64_t KeyOf(sensor::Label label, int tile_x, int tile_y);
  // The tile with that key as an index into tiles_.
  uint32_t FindOrAddTile(uint64_t key);

  double resolution_m_;
  float inverse_resolution_;
  absl::flat_hash_map<uint64_t, uint32_t> tile_of_key_;
  std::vector<Tile> tiles_;
  std::vector<uint64_t> keys_;  // of tiles_, same order
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_SEMANTIC_GRID_H_
