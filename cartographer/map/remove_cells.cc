// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_cells.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cartographer/common/parallel.h"

namespace cartographer::map {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;
using Tile = SemanticGrid::Tile;

struct SplitTile {
  Tile kept, gone;
};

// `rule` is asked for the cells with hits, by their place in the grid.
template <typename Rule>
SplitTile Split(const SemanticGrid::TileIndex& index, const Tile& tile, const Rule& rule) {
  SplitTile split{tile, {}};
  const CellIndex corner = CellIndex(index.x, index.y) * SemanticGrid::kTileSize;
  for (int i = 0; i < static_cast<int>(tile.hits.size()); ++i) {
    if (tile.hits[i] == 0) continue;
    const CellIndex offset(i % SemanticGrid::kTileSize, i / SemanticGrid::kTileSize);
    if (rule(CellIndex(corner + offset), tile.hits[i])) {
      std::swap(split.kept.hits[i], split.gone.hits[i]);
    }
  }
  return split;
}

bool IsEmpty(const Tile& tile) {
  return std::all_of(tile.hits.begin(), tile.hits.end(), [](uint16_t hits) { return hits == 0; });
}

struct SplitGrid {
  explicit SplitGrid(double resolution_m) : kept(resolution_m), gone(resolution_m) {}
  SemanticGrid kept, gone;
};

template <typename Rule>
SplitGrid Split(const SemanticGrid& grid, const sensor::LabelMask& labels, const Rule& rule) {
  SplitGrid split(grid.resolution_m());
  for (const sensor::Label label : grid.Labels()) {
    for (const auto& [index, tile] : grid.LayerOf(label)) {
      if (!labels.Contains(label)) {
        split.kept.SetTile(label, index, *tile);
        continue;
      }
      const SplitTile parts = Split(
          index, *tile, [&](const CellIndex& cell, int hits) { return rule(label, cell, hits); });
      if (!IsEmpty(parts.kept)) split.kept.SetTile(label, index, parts.kept);
      if (!IsEmpty(parts.gone)) split.gone.SetTile(label, index, parts.gone);
    }
  }
  return split;
}

// Returns what was removed, nullopt if nothing was.
std::optional<SemanticGrid> RemoveCells(const Region& region, const sensor::LabelMask& labels,
                                        const CellRule& rule, MapSubmap* placed) {
  const SemanticGrid& grid = placed->submap->grid;
  const Eigen::Isometry2d map_from_grid = submap::MapFromGrid(*placed);
  SplitGrid split = Split(grid, labels, [&](sensor::Label label, const CellIndex& cell, int hits) {
    return region.Contains(map_from_grid * grid.CenterOf(cell)) && rule(label, cell, hits);
  });
  if (split.gone.num_tiles() == 0) return std::nullopt;
  auto changed = std::make_shared<submap::Submap>(*placed->submap);
  changed->grid = std::move(split.kept);
  placed->submap = std::move(changed);
  return std::move(split.gone);
}

}  // namespace

LostCells RemoveCells(const FilterScope& scope, const sensor::LabelMask& labels,
                      const std::function<CellRule(const submap::SubmapId&)>& rule_of, Map* map) {
  std::vector<std::pair<submap::SubmapId, MapSubmap*>> submaps;
  for (auto& [id, placed] : map->submaps) {
    if (scope.Contains(id)) submaps.emplace_back(id, &placed);
  }
  auto gone = common::ParallelMapChunks<std::optional<SemanticGrid>>(
      submaps.size(), 1, [&](size_t i, size_t) -> std::optional<SemanticGrid> {
        const CellRule rule = rule_of(submaps[i].first);
        if (!rule) return std::nullopt;
        return RemoveCells(scope.region, labels, rule, submaps[i].second);
      });
  LostCells lost;
  for (size_t i = 0; i < submaps.size(); ++i) {
    if (gone[i].has_value()) lost.emplace(submaps[i].first, *std::move(gone[i]));
  }
  return lost;
}

}  // namespace cartographer::map
