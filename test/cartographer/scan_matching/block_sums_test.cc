// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/block_sums.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace cartographer::scan_matching {
namespace {

TEST(BlockSumsTest, FastSumsEqualPlainOnes) {
  std::mt19937 random(7);
  constexpr int kStride = 50, kRows = 40;
  std::vector<uint8_t> bytes(kStride * kRows);
  for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
  for (const int side : {4, 8}) {
    for (int num_lookups = 0; num_lookups < 20; ++num_lookups) {
      std::vector<Lookup> lookups;
      for (int i = 0; i < num_lookups; ++i) {
        const int x = static_cast<int>(random() % (kStride - side + 1));
        const int y = static_cast<int>(random() % (kRows - side + 1));
        lookups.push_back({y * kStride + x, static_cast<int>(random() % 32768)});
      }
      std::vector<int32_t> expected(side * side), sums(side * side, -1);
      SumBlockPortably(bytes.data(), kStride, side, lookups.data(), num_lookups, expected.data());
      lookups.push_back({});
      SumBlock(bytes.data(), kStride, side, lookups.data(), num_lookups, sums.data());
      EXPECT_EQ(sums, expected);
    }
  }
}

TEST(BlockSumsTest, TheLargestWeightsAndBytesDoNotOverflow) {
  const std::vector<uint8_t> bytes(64, 255);
  std::vector<Lookup> lookups(100, Lookup{0, 32767});
  std::vector<int32_t> sums(64);
  SumBlock(bytes.data(), 8, 8, lookups.data(), 100, sums.data());
  EXPECT_EQ(sums, std::vector<int32_t>(64, 100 * 255 * 32767));
}

TEST(BlockSumsTest, PlainSumsAreWhatTheHeaderSays) {
  std::vector<uint8_t> bytes(64);
  for (int i = 0; i < 64; ++i) bytes[i] = static_cast<uint8_t>(i);
  std::vector<int32_t> sums(16);
  const Lookup lookups[] = {{0, 2}, {5, 3}};
  SumBlockPortably(bytes.data(), 10, 4, lookups, 2, sums.data());
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      EXPECT_EQ(sums[y * 4 + x], 2 * (10 * y + x) + 3 * (10 * y + x + 5));
    }
  }
}

}  // namespace
}  // namespace cartographer::scan_matching
