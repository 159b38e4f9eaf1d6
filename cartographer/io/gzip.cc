// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/gzip.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>

#include "absl/strings/str_cat.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

constexpr int kLevel = 6;
// RFC 1952: 10 bytes of header, at least 2 of data, 8 of trailer (CRC-32 and size).
constexpr size_t kMinMemberSize = 20;
// No deflate stream expands further.
constexpr size_t kMaxRatio = 1032;
// The first attempt's buffer, in sizes of the member; grids of maps rarely expand further.
constexpr size_t kFirstRatio = 32;
constexpr size_t kGrowth = 4;

struct FreeCompressor {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};
struct FreeDecompressor {
  void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
};

absl::Status Damaged() {
  return absl::DataLossError("is damaged: its gzip data is invalid or its checksum is wrong");
}

}  // namespace

std::string GzipCompress(absl::string_view data) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(kLevel));
  CHECK(compressor != nullptr);
  std::string member(libdeflate_gzip_compress_bound(compressor.get(), data.size()), '\0');
  const size_t size = libdeflate_gzip_compress(compressor.get(), data.data(), data.size(),
                                               member.data(), member.size());
  CHECK_GT(size, 0u);
  member.resize(size);
  member.shrink_to_fit();
  return member;
}

size_t GzipClaimedSize(absl::string_view member) {
  if (member.size() < kMinMemberSize) return 0;
  size_t size = 0;
  for (int i = 1; i <= 4; ++i) {
    size = size << 8 | static_cast<unsigned char>(member[member.size() - i]);
  }
  return size;
}

absl::StatusOr<std::string> GzipDecompress(absl::string_view member, size_t max_size) {
  if (member.size() < kMinMemberSize) return Damaged();
  const size_t claimed_size = GzipClaimedSize(member);
  if (claimed_size > max_size) {
    return absl::DataLossError(absl::StrCat("decompresses to ", claimed_size,
                                            " bytes, more than the ", max_size, " allowed"));
  }
  if (claimed_size / kMaxRatio > member.size()) return Damaged();
  const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
      libdeflate_alloc_decompressor());
  CHECK(decompressor != nullptr);
  for (size_t capacity = kFirstRatio * member.size();; capacity *= kGrowth) {
    std::string data(std::min(capacity, claimed_size), '\0');
    size_t read = 0, written = 0;
    const libdeflate_result result =
        libdeflate_gzip_decompress_ex(decompressor.get(), member.data(), member.size(), data.data(),
                                      data.size(), &read, &written);
    if (result == LIBDEFLATE_INSUFFICIENT_SPACE && capacity < claimed_size) continue;
    if (result != LIBDEFLATE_SUCCESS || read != member.size() || written != data.size()) {
      return Damaged();
    }
    return data;
  }
}

}  // namespace cartographer::io
