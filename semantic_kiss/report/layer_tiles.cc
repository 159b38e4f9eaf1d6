// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/layer_tiles.h"

#include <algorithm>
#include <utility>

#include "cartographer/common/parallel.h"
#include "glog/logging.h"

namespace semantic_kiss::report {

int NumHalvings(int width, int height, int tile_side) {
  int halvings = 0;
  for (int side = std::max(width, height); side > 2 * tile_side; side = (side + 1) / 2) ++halvings;
  return halvings;
}

std::vector<LayerTile> CutIntoTiles(AlphaImage image, int halvings, int tile_side, const Ink& ink) {
  CHECK_GT(tile_side, 0);
  std::vector<LayerTile> tiles;
  for (int level = 0; level <= halvings; ++level) {
    if (level > 0) image = Halved(image);
    const int across = (image.width + tile_side - 1) / tile_side;
    const int down = (image.height + tile_side - 1) / tile_side;
    std::vector<LayerTile> found = cartographer::common::ParallelMapChunks<
        LayerTile>(static_cast<size_t>(across) * down, 1, [&](size_t index, size_t) {
      LayerTile tile{level, static_cast<int>(index) % across, static_cast<int>(index) / across, ""};
      const AlphaImage piece =
          CutOut(image, tile.column * tile_side, tile.row * tile_side, tile_side);
      if (!IsEmpty(piece)) tile.png = ToPng(piece, ink);
      return tile;
    });
    for (LayerTile& tile : found) {
      if (!tile.png.empty()) tiles.push_back(std::move(tile));
    }
  }
  return tiles;
}

}  // namespace semantic_kiss::report
