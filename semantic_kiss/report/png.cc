// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/png.h"

#include <libdeflate.h>

#include <memory>

#include "absl/strings/string_view.h"
#include "glog/logging.h"

namespace semantic_kiss::report {
namespace {

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

std::string ZlibCompressed(const std::string& data, int effort) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(effort));
  CHECK(compressor != nullptr);
  std::string compressed(libdeflate_zlib_compress_bound(compressor.get(), data.size()), '\0');
  compressed.resize(libdeflate_zlib_compress(compressor.get(), data.data(), data.size(),
                                             compressed.data(), compressed.size()));
  CHECK(!compressed.empty());
  return compressed;
}

}  // namespace

std::string PngFile(const PalettePicture& picture, int effort) {
  CHECK_GT(picture.width, 0);
  CHECK_GT(picture.height, 0);
  // Bits, palette; usual compression, filters and order.
  const std::string format = {static_cast<char>(picture.bits), 3, 0, 0, 0};
  return std::string("\x89PNG\r\n\x1a\n") +
         Chunk("IHDR", BigEndian(picture.width) + BigEndian(picture.height) + format) +
         Chunk("PLTE", picture.palette) + Chunk("tRNS", picture.opacities) +
         Chunk("IDAT", ZlibCompressed(picture.rows, effort)) + Chunk("IEND", "");
}

}  // namespace semantic_kiss::report
