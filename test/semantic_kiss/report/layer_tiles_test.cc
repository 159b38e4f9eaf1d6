// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/layer_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "test/cartographer/io/on_threads.h"
#include "test/semantic_kiss/report/decoded_png.h"

namespace semantic_kiss::report {
namespace {

using semantic_kiss_testing::DecodedPng;
using semantic_kiss_testing::DecodePng;

AlphaImage Speckled(int width, int height) {
  constexpr int kSeed = 20260301;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  AlphaImage image(width, height);
  for (uint8_t& level : image.levels) level = random() % 4 == 0 ? random() % 16 : 0;
  return image;
}

// Puts the tiles of one level together again.
AlphaImage Assembled(const std::vector<LayerTile>& tiles, int level, int side, AlphaImage canvas) {
  for (const LayerTile& tile : tiles) {
    if (tile.level != level) continue;
    const DecodedPng png = DecodePng(tile.png);
    EXPECT_EQ(png.width, side);
    EXPECT_EQ(png.height, side);
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const int x = tile.column * side + column, y = tile.row * side + row;
        const uint32_t alpha = png.pixels[row * side + column] >> 24;
        if (x >= canvas.width || y >= canvas.height) {
          EXPECT_EQ(alpha, 0u);
        } else {
          canvas.Row(y)[x] = static_cast<uint8_t>(alpha / 17);
        }
      }
    }
  }
  return canvas;
}

TEST(LayerTilesTest, TilesAreTheImageAndItsHalves) {
  AlphaImage image = Speckled(53, 37);
  const std::vector<LayerTile> tiles = CutIntoTiles(image, 2, 16, {{9, 9, 9}});
  for (int level = 0; level <= 2; ++level) {
    if (level > 0) image = Halved(image);
    EXPECT_EQ(Assembled(tiles, level, 16, AlphaImage(image.width, image.height)).levels,
              image.levels)
        << "level " << level;
  }
}

TEST(LayerTilesTest, EmptyTilesAreLeftOut) {
  AlphaImage image(64, 64);
  EXPECT_TRUE(CutIntoTiles(image, 1, 16, {}).empty());
  image.Row(40)[20] = kOpaque;
  const std::vector<LayerTile> tiles = CutIntoTiles(image, 1, 16, {});
  ASSERT_EQ(tiles.size(), 2u);
  EXPECT_EQ(tiles[0].level, 0);
  EXPECT_EQ(tiles[0].column, 1);
  EXPECT_EQ(tiles[0].row, 2);
  EXPECT_EQ(tiles[1].level, 1);
  EXPECT_EQ(tiles[1].column, 0);
  EXPECT_EQ(tiles[1].row, 1);
}

TEST(LayerTilesTest, ThreadsDoNotMatter) {
  const auto bytes = [] {
    std::string all;
    for (const LayerTile& tile : CutIntoTiles(Speckled(130, 90), 2, 16, {{1, 2, 3}}))
      all += tile.png;
    return all;
  };
  const std::string one = cartographer::io::OnThreads(1, bytes);
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(one, cartographer::io::OnThreads(8, bytes));
}

TEST(LayerTilesTest, HalvesUntilTwoTilesSuffice) {
  EXPECT_EQ(NumHalvings(1, 1, 16), 0);
  EXPECT_EQ(NumHalvings(32, 5, 16), 0);
  EXPECT_EQ(NumHalvings(5, 33, 16), 1);
  EXPECT_EQ(NumHalvings(65, 1, 16), 2);
  EXPECT_EQ(NumHalvings(3000, 2000, 512), 2);
}

}  // namespace
}  // namespace semantic_kiss::report
