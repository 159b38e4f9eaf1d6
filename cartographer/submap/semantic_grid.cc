// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/semantic_grid.h"

#include <algorithm>
#include <limits>

#include "glog/logging.h"

namespace cartographer::submap {
namespace {

constexpr int kTileBits = 4;
static_assert(1 << kTileBits == SemanticGrid::kTileSize);
constexpr int kTileMask = SemanticGrid::kTileSize - 1;

// Tile indices are stored in 28 bits each, shifted to be non-negative.
constexpr int kTileIndexOffset = 1 << 27;
constexpr uint64_t kTileIndexMask = (uint64_t{1} << 28) - 1;

sensor::Label LabelOfKey(uint64_t key) { return sensor::Label{static_cast<uint8_t>(key >> 56)}; }

SemanticGrid::TileIndex TileOfKey(uint64_t key) {
  return {static_cast<int>(key & kTileIndexMask) - kTileIndexOffset,
          static_cast<int>((key >> 28) & kTileIndexMask) - kTileIndexOffset};
}

int CellInTile(const CellIndex& cell) {
  return (cell.y() & kTileMask) * SemanticGrid::kTileSize + (cell.x() & kTileMask);
}

uint16_t SaturatedSum(int a, int b) {
  return static_cast<uint16_t>(std::min(int64_t{a} + b, int64_t{SemanticGrid::kMaxHits}));
}

// Whether `hits` of `label` beat the best so far. Labels come in ascending order, so that a tie
// stays with the smaller one; kUnlabeled comes first and yields to any other.
bool Beats(int hits, sensor::Label best_label, int best_hits) {
  return hits > 0 && (hits > best_hits || best_label == sensor::kUnlabeled);
}

}  // namespace

SemanticGrid::SemanticGrid(double resolution_m)
    : resolution_m_(resolution_m), inverse_resolution_(static_cast<float>(1. / resolution_m)) {
  CHECK_GT(resolution_m, 0.);
}

uint64_t SemanticGrid::KeyOf(sensor::Label label, int tile_x, int tile_y) {
  return static_cast<uint64_t>(sensor::Index(label)) << 56 |
         (static_cast<uint64_t>(tile_y + kTileIndexOffset) & kTileIndexMask) << 28 |
         (static_cast<uint64_t>(tile_x + kTileIndexOffset) & kTileIndexMask);
}

uint32_t SemanticGrid::FindOrAddTile(uint64_t key) {
  const auto [it, inserted] = tile_of_key_.try_emplace(key, static_cast<uint32_t>(tiles_.size()));
  if (inserted) {
    tiles_.emplace_back();
    keys_.push_back(key);
  }
  return it->second;
}

void SemanticGrid::AddHits(sensor::Label label, const CellIndex& cell, int hits) {
  DCHECK_GT(hits, 0);
  const uint32_t tile = FindOrAddTile(KeyOf(label, cell.x() >> kTileBits, cell.y() >> kTileBits));
  uint16_t& count = tiles_[tile].hits[CellInTile(cell)];
  count = SaturatedSum(count, hits);
}

void SemanticGrid::AddCloud(const sensor::LabeledPointCloud& cloud,
                            const transform::Rigid3d& grid_from_cloud,
                            const sensor::LabelMask& dropped) {
  const Eigen::Matrix<float, 2, 4> plane_from_cloud =
      grid_from_cloud.Matrix().topRows<2>().cast<float>();
  // Neighbours in a scan mostly fall into the same tile, which saves the look-up.
  uint64_t last_key = std::numeric_limits<uint64_t>::max();
  uint32_t last_tile = 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const sensor::Label label = cloud.labels[i];
    if (dropped.Contains(label)) continue;
    const Eigen::Vector2f position =
        plane_from_cloud.leftCols<3>() * cloud.positions[i] + plane_from_cloud.col(3);
    const CellIndex cell = CellOf(position);
    const uint64_t key = KeyOf(label, cell.x() >> kTileBits, cell.y() >> kTileBits);
    if (key != last_key) {
      last_key = key;
      last_tile = FindOrAddTile(key);
    }
    uint16_t& count = tiles_[last_tile].hits[CellInTile(cell)];
    count = SaturatedSum(count, 1);
  }
}

int SemanticGrid::Hits(sensor::Label label, const CellIndex& cell) const {
  const auto it = tile_of_key_.find(KeyOf(label, cell.x() >> kTileBits, cell.y() >> kTileBits));
  return it == tile_of_key_.end() ? 0 : tiles_[it->second].hits[CellInTile(cell)];
}

SemanticGrid::DominantLabel SemanticGrid::Dominant(const CellIndex& cell) const {
  DominantLabel best;
  for (size_t i = 0; i < sensor::kMaxLabels; ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    const int hits = Hits(label, cell);
    if (Beats(hits, best.label, best.hits)) best = {label, hits};
  }
  return best;
}

std::vector<sensor::Label> SemanticGrid::Labels() const {
  std::vector<sensor::Label> labels;
  for (const uint64_t key : keys_) labels.push_back(LabelOfKey(key));
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

SemanticGrid::Layer SemanticGrid::LayerOf(sensor::Label label) const {
  Layer layer;
  for (size_t i = 0; i < tiles_.size(); ++i) {
    if (LabelOfKey(keys_[i]) == label) layer.emplace(TileOfKey(keys_[i]), &tiles_[i]);
  }
  return layer;
}

std::map<SemanticGrid::TileIndex, SemanticGrid::DominantTile> SemanticGrid::DominantTiles() const {
  // Ascending keys are ascending labels first, as Beats() wants them.
  std::vector<std::pair<uint64_t, uint32_t>> order(tile_of_key_.begin(), tile_of_key_.end());
  std::sort(order.begin(), order.end());
  std::map<TileIndex, DominantTile> result;
  for (const auto& [key, tile] : order) {
    const sensor::Label label = LabelOfKey(key);
    DominantTile& dominant = result[TileOfKey(key)];
    for (size_t cell = 0; cell < dominant.hits.size(); ++cell) {
      const uint16_t hits = tiles_[tile].hits[cell];
      if (Beats(hits, dominant.labels[cell], dominant.hits[cell])) {
        dominant.labels[cell] = label;
        dominant.hits[cell] = hits;
      }
    }
  }
  return result;
}

void SemanticGrid::SetTile(sensor::Label label, const TileIndex& index, const Tile& tile) {
  tiles_[FindOrAddTile(KeyOf(label, index.x, index.y))] = tile;
}

void SemanticGrid::RemoveLayers(const sensor::LabelMask& mask) {
  size_t kept = 0;
  for (size_t i = 0; i < tiles_.size(); ++i) {
    if (mask.Contains(LabelOfKey(keys_[i]))) {
      tile_of_key_.erase(keys_[i]);
      continue;
    }
    tile_of_key_[keys_[i]] = static_cast<uint32_t>(kept);
    if (kept != i) {
      keys_[kept] = keys_[i];
      tiles_[kept] = tiles_[i];
    }
    ++kept;
  }
  keys_.resize(kept);
  tiles_.resize(kept);
}

SemanticGrid::CellBox SemanticGrid::Bounds() const {
  if (keys_.empty()) return {};
  CellIndex min = CellIndex::Constant(std::numeric_limits<int>::max());
  CellIndex max = CellIndex::Constant(std::numeric_limits<int>::min());
  for (const uint64_t key : keys_) {
    const TileIndex tile = TileOfKey(key);
    min = min.min(CellIndex(tile.x, tile.y));
    max = max.max(CellIndex(tile.x, tile.y));
  }
  return {min * kTileSize, (max + 1) * kTileSize};
}

}  // namespace cartographer::submap
