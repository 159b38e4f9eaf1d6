// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/alpha_image.h"

#include <libdeflate.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "absl/strings/string_view.h"
#include "glog/logging.h"

namespace semantic_kiss::report {
namespace {

constexpr int kCompressionLevel = 9;
constexpr int kPaletteSize = kOpaque + 1;

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
  }
};

std::string BigEndian(uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
          static_cast<char>(value >> 8), static_cast<char>(value)};
}

std::string Chunk(absl::string_view kind, absl::string_view data) {
  const std::string covered = std::string(kind) + std::string(data);
  return BigEndian(data.size()) + covered +
         BigEndian(libdeflate_crc32(0, covered.data(), covered.size()));
}

std::string ZlibCompressed(const std::string& data) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(kCompressionLevel));
  CHECK(compressor != nullptr);
  std::string compressed(libdeflate_zlib_compress_bound(compressor.get(), data.size()), '\0');
  compressed.resize(libdeflate_zlib_compress(compressor.get(), data.data(), data.size(),
                                             compressed.data(), compressed.size()));
  CHECK(!compressed.empty());
  return compressed;
}

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
  CHECK_GT(image.width, 0);
  CHECK_GT(image.height, 0);
  // Four bits, palette; usual compression, filters and order.
  const std::string format = {4, 3, 0, 0, 0};
  std::string palette, opacities;
  for (int level = 0; level < kPaletteSize; ++level) {
    palette += {static_cast<char>(ink.color.red), static_cast<char>(ink.color.green),
                static_cast<char>(ink.color.blue)};
    opacities.push_back(static_cast<char>(std::lround(ink.opacity * level * 255. / kOpaque)));
  }
  return std::string("\x89PNG\r\n\x1a\n") +
         Chunk("IHDR", BigEndian(image.width) + BigEndian(image.height) + format) +
         Chunk("PLTE", palette) + Chunk("tRNS", opacities) +
         Chunk("IDAT", ZlibCompressed(PackedRows(image))) + Chunk("IEND", "");
}

}  // namespace semantic_kiss::report
