// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/byte_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cartographer::scan_matching {
namespace {

ByteImage RandomImage(std::mt19937* random) {
  const auto draw = [random](int min, int max) {
    return std::uniform_int_distribution<int>(min, max)(*random);
  };
  ByteImage image(draw(-20, 20), draw(-20, 20), draw(1, 40), draw(1, 40));
  for (uint8_t& byte : image.bytes) byte = static_cast<uint8_t>(draw(0, 3) == 0 ? draw(0, 255) : 0);
  return image;
}

int MaximumOver(const ByteImage& image, int x0, int y0, int side) {
  int maximum = 0;
  for (int y = y0; y < y0 + side; ++y) {
    for (int x = x0; x < x0 + side; ++x) maximum = std::max<int>(maximum, image.At(x, y));
  }
  return maximum;
}

TEST(ByteImageTest, SlidingMaximaEqualPlainOnes) {
  std::mt19937 random(1);
  for (int i = 0; i < 40; ++i) {
    const ByteImage image = RandomImage(&random);
    const int window = 1 + i % 12;
    const ByteImage maxima = SlidingMaxima(image, window);
    for (int y = -50; y < 70; ++y) {
      for (int x = -50; x < 70; ++x) {
        ASSERT_EQ(maxima.At(x, y), MaximumOver(image, x, y, window)) << i << " " << x << " " << y;
      }
    }
  }
}

TEST(ByteImageTest, BlockMaximaEqualPlainOnes) {
  std::mt19937 random(2);
  for (int i = 0; i < 40; ++i) {
    const ByteImage image = RandomImage(&random);
    const int log2_step = i % 5, step = 1 << log2_step;
    const ByteImage maxima = BlockMaxima(image, log2_step);
    for (int y = -30; y < 70; ++y) {
      for (int x = -30; x < 70; ++x) {
        ASSERT_EQ(maxima.At(x, y), MaximumOver(image, x * step, y * step, step)) << i;
      }
    }
  }
}

TEST(ByteImageTest, MaxIntoKeepsTheLarger) {
  ByteImage image(0, 0, 3, 1), other(1, 0, 2, 1);
  image.bytes = {1, 5, 2};
  other.bytes = {3, 4};
  MaxInto(other, &image);
  EXPECT_EQ(image.bytes, std::vector<uint8_t>({1, 5, 4}));
}

}  // namespace
}  // namespace cartographer::scan_matching
