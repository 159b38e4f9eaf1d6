// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/alpha_image.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "glog/logging.h"
#include "semantic_kiss/report/png.h"

namespace semantic_kiss::report {
namespace {

constexpr int kCompressionLevel = 9;
constexpr int kPaletteSize = kOpaque + 1;

// Two pixels a byte, the left one in the upper half; a filter type of 0 before each row.
std::string PackedRows(const AlphaImage& image) {
  const int row_bytes = (image.width + 1) / 2;
  std::string packed;
  packed.reserve((row_bytes + size_t{1}) * image.height);
  for (int row = 0; row < image.height; ++row) {
    packed.push_back(0);
    const uint8_t* const levels = image.Row(row);
    for (int column = 0; column < image.width; column += 2) {
      const int right = column + 1 < image.width ? levels[column + 1] : 0;
      packed.push_back(static_cast<char>(levels[column] << 4 | right));
    }
  }
  return packed;
}

}  // namespace

AlphaImage CutOut(const AlphaImage& image, int column, int row, int side) {
  AlphaImage result(side, side);
  const int width = std::min(side, image.width - column);
  const int height = std::min(side, image.height - row);
  for (int y = 0; y < height; ++y) {
    std::copy_n(image.Row(row + y) + column, std::max(width, 0), result.Row(y));
  }
  return result;
}

AlphaImage Halved(const AlphaImage& image) {
  AlphaImage result((image.width + 1) / 2, (image.height + 1) / 2);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      int sum = 0, strongest = 0;
      for (int row = 2 * y; row < std::min(2 * y + 2, image.height); ++row) {
        for (int column = 2 * x; column < std::min(2 * x + 2, image.width); ++column) {
          sum += image.Row(row)[column];
          strongest = std::max<int>(strongest, image.Row(row)[column]);
        }
      }
      result.Row(y)[x] = static_cast<uint8_t>((sum + 4 * strongest + 4) / 8);
    }
  }
  return result;
}

bool IsEmpty(const AlphaImage& image) {
  return std::all_of(image.levels.begin(), image.levels.end(),
                     [](uint8_t level) { return level == 0; });
}

std::string ToPng(const AlphaImage& image, const Ink& ink) {
  PalettePicture picture{image.width, image.height, 4, "", "", PackedRows(image)};
  for (int level = 0; level < kPaletteSize; ++level) {
    picture.palette += {static_cast<char>(ink.color.red), static_cast<char>(ink.color.green),
                        static_cast<char>(ink.color.blue)};
    picture.opacities.push_back(
        static_cast<char>(std::lround(ink.opacity * level * 255. / kOpaque)));
  }
  return PngFile(picture, kCompressionLevel);
}

}  // namespace semantic_kiss::report
