// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/semantic_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "cartographer/common/parallel.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

using submap::SemanticGrid;

// Half-open box of pixels.
struct PixelBox {
  int min_column = 0, min_row = 0, max_column = 0, max_row = 0;
  bool Empty() const { return min_column >= max_column || min_row >= max_row; }
  int Width() const { return max_column - min_column; }
};

PixelBox Intersection(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.min_column, b.min_column), std::max(a.min_row, b.min_row),
          std::min(a.max_column, b.max_column), std::min(a.max_row, b.max_row)};
}

// Converts to int without overflow: pixels this far out are outside of any image.
int ClampedInt(double value) { return static_cast<int>(std::clamp(value, -1e9, 1e9)); }

struct PlacedTile {
  sensor::Label label;
  SemanticGrid::TileIndex index;
  const SemanticGrid::Tile* tile;
  PixelBox box;  // contains the tile's footprint
};

// A submap's grid within the image. Cell coordinates are continuous; cell (x, y) covers
// [x, x + 1) x [y, y + 1). The map between them and the image's is
//   pixel = pixel_from_cell * cell + origin, a rotation and a scale.
struct PlacedGrid {
  Eigen::Matrix2d pixel_from_cell;
  Eigen::Matrix2d cell_from_pixel;
  Eigen::Vector2d origin;
  double cell_side_px = 0.;
  std::vector<PlacedTile> tiles;  // labels ascending
  PixelBox box;
};

PixelBox FootprintOf(const PlacedGrid& grid, const SemanticGrid::TileIndex& index) {
  constexpr double kSize = SemanticGrid::kTileSize;
  const Eigen::Vector2d middle((index.x + 0.5) * kSize, (index.y + 0.5) * kSize);
  const Eigen::Vector2d center = grid.pixel_from_cell * middle + grid.origin;
  const Eigen::Vector2d reach =
      0.5 * kSize * grid.pixel_from_cell.cwiseAbs().rowwise().sum().array() + 1.;
  return {ClampedInt(std::floor(center.x() - reach.x())),
          ClampedInt(std::floor(center.y() - reach.y())),
          ClampedInt(std::ceil(center.x() + reach.x())),
          ClampedInt(std::ceil(center.y() + reach.y()))};
}

PlacedGrid Place(const map::MapSubmap& placed, const sensor::LabelMask& hidden,
                 const RasterFrame& frame) {
  PlacedGrid result;
  const SemanticGrid& grid = placed.submap->grid;
  const double yaw = transform::Yaw(placed.map_from_submap.rotation());
  result.cell_side_px = grid.resolution_m() / frame.resolution_m;
  Eigen::Matrix2d rotation;  // with y turned over
  rotation << std::cos(yaw), -std::sin(yaw), -std::sin(yaw), -std::cos(yaw);
  result.pixel_from_cell = rotation * result.cell_side_px;
  result.cell_from_pixel = rotation.transpose() / result.cell_side_px;
  result.origin = frame.PixelFromMap(placed.map_from_submap.translation().head<2>());

  const PixelBox image{0, 0, frame.width, frame.height};
  for (const sensor::Label label : grid.Labels()) {
    if (hidden.Contains(label)) continue;
    for (const auto& [index, tile] : grid.LayerOf(label)) {
      const PixelBox box = Intersection(FootprintOf(result, index), image);
      if (box.Empty()) continue;
      if (result.tiles.empty()) result.box = box;
      result.box = {std::min(result.box.min_column, box.min_column),
                    std::min(result.box.min_row, box.min_row),
                    std::max(result.box.max_column, box.max_column),
                    std::max(result.box.max_row, box.max_row)};
      result.tiles.push_back({label, index, tile, box});
    }
  }
  return result;
}

// Sums hits by label over a box of pixels that is small enough for the cache.
class Accumulator {
 public:
  explicit Accumulator(const PixelBox& box)
      : box_(box), size_(static_cast<size_t>(box.Width()) * (box.max_row - box.min_row)) {}

  void Add(const PlacedGrid& grid) {
    // Cells on a lattice of this pitch leave no pixel empty, however they are turned.
    const bool cells_cover_pixels = grid.cell_side_px * std::sqrt(2.) <= 1.;
    for (const PlacedTile& tile : grid.tiles) {
      const PixelBox box = Intersection(tile.box, box_);
      if (box.Empty()) continue;
      cells_cover_pixels ? AddCells(grid, tile) : AddPixels(grid, tile, box);
    }
  }

  // Writes the dominant labels into the raster.
  void Finish(SemanticRaster* raster) const {
    for (size_t i = 0; i < layers_.size(); ++i) {
      if (layers_[i].empty()) continue;
      const sensor::Label label{static_cast<uint8_t>(i)};
      const float* sums = layers_[i].data();
      for (int row = box_.min_row; row < box_.max_row; ++row) {
        size_t index = raster->IndexOf(box_.min_column, row);
        for (int column = box_.min_column; column < box_.max_column; ++column, ++index, ++sums) {
          const bool beats = *sums > raster->hits[index] ||
                             (*sums > 0.f && raster->labels[index] == sensor::kUnlabeled);
          if (!beats) continue;
          raster->labels[index] = label;
          raster->hits[index] = *sums;
        }
      }
    }
  }

 private:
  std::vector<float>& LayerOf(sensor::Label label) {
    std::vector<float>& layer = layers_[sensor::Index(label)];
    if (layer.empty()) layer.resize(size_);
    return layer;
  }

  // Pixels that are larger than a cell look up four cells, so that lines of single cells survive.
  void AddPixels(const PlacedGrid& grid, const PlacedTile& tile, const PixelBox& box) {
    const int samples = grid.cell_side_px >= 1. ? 1 : 2;
    const double cells = 1. / (grid.cell_side_px * grid.cell_side_px);
    const float share = static_cast<float>(cells / (samples * samples));
    for (int row = 0; row < samples; ++row) {
      for (int column = 0; column < samples; ++column) {
        const Eigen::Vector2d offset((column + 0.5) / samples, (row + 0.5) / samples);
        AddSamples(grid, tile, box, {offset, share});
      }
    }
  }

  struct Sampling {
    Eigen::Vector2d offset;  // within the pixel, in [0, 1)
    float share;             // of the cell's hits that go to the pixel
  };

  void AddSamples(const PlacedGrid& grid, const PlacedTile& tile, const PixelBox& box,
                  const Sampling& sampling) {
    constexpr int kSize = SemanticGrid::kTileSize;
    std::vector<float>& layer = LayerOf(tile.label);
    const Eigen::Vector2d step = grid.cell_from_pixel.col(0);
    const Eigen::Vector2d start = sampling.offset - grid.origin;
    const double tile_x = tile.index.x * double{kSize};
    const double tile_y = tile.index.y * double{kSize};
    for (int row = box.min_row; row < box.max_row; ++row) {
      const Eigen::Vector2d row_start = grid.cell_from_pixel.col(1) * (row + start.y());
      float* sums = &layer[static_cast<size_t>(row - box_.min_row) * box_.Width()];
      for (int column = box.min_column; column < box.max_column; ++column) {
        // The cell in the grid comes first, without regard to the tile: tiles that share an edge
        // then agree to the bit about the pixels there.
        const double along = column + start.x();
        const double x = std::floor(row_start.x() + step.x() * along) - tile_x;
        const double y = std::floor(row_start.y() + step.y() * along) - tile_y;
        if (x < 0. || y < 0. || x >= kSize || y >= kSize) continue;
        sums[column - box_.min_column] +=
            sampling.share * tile.tile->hits[static_cast<int>(y) * kSize + static_cast<int>(x)];
      }
    }
  }

  void AddCells(const PlacedGrid& grid, const PlacedTile& tile) {
    constexpr int kSize = SemanticGrid::kTileSize;
    std::vector<float>& layer = LayerOf(tile.label);
    for (int cell = 0; cell < kSize * kSize; ++cell) {
      if (tile.tile->hits[cell] == 0) continue;
      const Eigen::Vector2d center((tile.index.x * double{kSize} + cell % kSize) + 0.5,
                                   (tile.index.y * double{kSize} + cell / kSize) + 0.5);
      const Eigen::Vector2d pixel = grid.pixel_from_cell * center + grid.origin;
      const int column = ClampedInt(std::floor(pixel.x()));
      const int row = ClampedInt(std::floor(pixel.y()));
      if (column < box_.min_column || column >= box_.max_column || row < box_.min_row ||
          row >= box_.max_row) {
        continue;
      }
      layer[static_cast<size_t>(row - box_.min_row) * box_.Width() + column - box_.min_column] +=
          tile.tile->hits[cell];
    }
  }

  const PixelBox box_;
  const size_t size_;
  std::vector<std::vector<float>> layers_ = std::vector<std::vector<float>>(sensor::kMaxLabels);
};

}  // namespace

SemanticRaster ComposeRaster(const map::Map& map, const sensor::LabelMask& hidden,
                             const RasterFrame& frame) {
  CHECK_GT(frame.resolution_m, 0.);
  SemanticRaster raster;
  raster.frame = frame;
  raster.labels.assign(frame.size(), sensor::kUnlabeled);
  raster.hits.assign(frame.size(), 0.f);

  std::vector<const map::MapSubmap*> submaps;
  for (const auto& entry : map.submaps) submaps.push_back(&entry.second);
  const std::vector<PlacedGrid> grids = common::ParallelMapChunks<PlacedGrid>(
      submaps.size(), 1, [&](size_t i, size_t) { return Place(*submaps[i], hidden, frame); });

  constexpr int kBlockSize = 128;
  const int blocks_across = (frame.width + kBlockSize - 1) / kBlockSize;
  const int blocks_down = (frame.height + kBlockSize - 1) / kBlockSize;
  const size_t num_blocks = static_cast<size_t>(blocks_across) * blocks_down;
  common::ParallelChunks(num_blocks, 1, [&](size_t block, size_t) {
    const int column = static_cast<int>(block % blocks_across) * kBlockSize;
    const int row = static_cast<int>(block / blocks_across) * kBlockSize;
    const PixelBox box{column, row, std::min(column + kBlockSize, frame.width),
                       std::min(row + kBlockSize, frame.height)};
    Accumulator accumulator(box);
    for (const PlacedGrid& grid : grids) {
      if (!Intersection(grid.box, box).Empty()) accumulator.Add(grid);
    }
    accumulator.Finish(&raster);
  });
  return raster;
}

}  // namespace cartographer::io
