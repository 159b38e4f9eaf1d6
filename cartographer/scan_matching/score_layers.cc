// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/score_layers.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

namespace cartographer::scan_matching {
namespace {

using submap::SemanticGrid;
using TileIndex = SemanticGrid::TileIndex;

constexpr int kTileSize = SemanticGrid::kTileSize;

bool IsNear(const TileIndex& tile) {
  constexpr int kMaxTile = kMaxCell / kTileSize;
  return tile.x >= -kMaxTile && tile.x < kMaxTile && tile.y >= -kMaxTile && tile.y < kMaxTile;
}

// The tiles of a label that counts, and where its agreement goes.
struct LabelTiles {
  sensor::Label label;
  int layer;
  SemanticGrid::Layer tiles;
};

std::vector<LabelTiles> TilesThatCount(const SemanticGrid& grid, const ScoreModel& model) {
  std::vector<LabelTiles> result;
  for (const sensor::Label label : grid.Labels()) {
    const int layer = model.LayerOf(label);
    if (layer == ScoreModel::kNotMatched) continue;
    result.push_back({label, layer, {}});
    for (const auto& [index, tile] : grid.LayerOf(label)) {
      if (IsNear(index)) result.back().tiles.emplace(index, tile);
    }
  }
  return result;
}

// A range of tiles along an axis; empty: begin > end.
struct Span {
  int begin = std::numeric_limits<int>::max();
  int end = std::numeric_limits<int>::min();
  void Include(int tile) {
    begin = std::min(begin, tile);
    end = std::max(end, tile + 1);
  }
  int size() const { return std::max(end, begin) - begin; }
};

std::vector<ByteImage> EmptyLayers(const std::vector<LabelTiles>& labels, int num_layers) {
  Span columns;
  std::vector<Span> rows(num_layers);
  for (const LabelTiles& label : labels) {
    for (const auto& [index, tile] : label.tiles) {
      columns.Include(index.x);
      rows[label.layer].Include(index.y);
    }
  }
  std::vector<ByteImage> layers;
  for (const Span& span : rows) {
    if (span.size() == 0) {
      layers.emplace_back(0, 0, 0, 0);
    } else {
      layers.emplace_back(columns.begin * kTileSize, span.begin * kTileSize,
                          columns.size() * kTileSize, span.size() * kTileSize);
    }
  }
  return layers;
}

// What the model says of a layer, for every number of hits up to where it saturates.
class AgreementTable {
 public:
  AgreementTable(const ScoreModel& model, int layer, bool dominant)
      : agreements_(model.SaturationOf(layer) + 1) {
    for (size_t hits = 0; hits < agreements_.size(); ++hits) {
      agreements_[hits] =
          static_cast<uint8_t>(model.Agreement(layer, static_cast<int>(hits), dominant));
    }
  }

  uint8_t operator[](size_t hits) const {
    return agreements_[std::min(hits, agreements_.size() - 1)];
  }

 private:
  std::vector<uint8_t> agreements_;
};

using DominantTiles = std::map<TileIndex, SemanticGrid::DominantTile>;

void Fill(const LabelTiles& label, const DominantTiles& dominant_tiles, const ScoreModel& model,
          ByteImage* image) {
  const AgreementTable if_dominant(model, label.layer, true);
  const AgreementTable if_not(model, label.layer, false);
  for (const auto& [index, tile] : label.tiles) {
    const SemanticGrid::DominantTile& dominant = dominant_tiles.at(index);
    for (int y = 0; y < kTileSize; ++y) {
      uint8_t* const row = image->Row(index.y * kTileSize + y) + (index.x * kTileSize - image->x0);
      for (int x = 0; x < kTileSize; ++x) {
        const size_t cell = y * kTileSize + x;
        const size_t hits = tile->hits[cell];
        if (hits == 0) continue;
        const uint8_t agreement =
            dominant.labels[cell] == label.label ? if_dominant[hits] : if_not[hits];
        row[x] = std::max(row[x], agreement);
      }
    }
  }
}

}  // namespace

std::vector<ByteImage> ScoreLayers(const SemanticGrid& grid, const ScoreModel& model) {
  const std::vector<LabelTiles> labels = TilesThatCount(grid, model);
  std::vector<ByteImage> layers = EmptyLayers(labels, model.num_layers());
  const DominantTiles dominant_tiles = grid.DominantTiles();
  for (const LabelTiles& label : labels) {
    Fill(label, dominant_tiles, model, &layers[label.layer]);
  }
  return layers;
}

}  // namespace cartographer::scan_matching
