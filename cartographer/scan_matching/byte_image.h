// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_BYTE_IMAGE_H_
#define CARTOGRAPHER_SCAN_MATCHING_BYTE_IMAGE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cartographer::scan_matching {

// A rectangle of bytes somewhere in an unbounded plane of zeros: [x0, x0 + width) x [y0, y0 +
// height), row-major.
struct ByteImage {
  ByteImage(int x0, int y0, int width, int height)
      : x0(x0), y0(y0), width(width), height(height), bytes(size_t(width) * height) {}

  uint8_t* Row(int y) { return &bytes[size_t(y - y0) * width]; }
  const uint8_t* Row(int y) const { return &bytes[size_t(y - y0) * width]; }
  // 0 outside of the rectangle.
  uint8_t At(int x, int y) const {
    const bool inside = x >= x0 && x < x0 + width && y >= y0 && y < y0 + height;
    return inside ? Row(y)[x - x0] : 0;
  }

  int x0, y0, width, height;
  std::vector<uint8_t> bytes;
};

// Takes the larger byte of both wherever `other` is not zero; it must lie within `image` (CHECKed).
void MaxInto(const ByteImage& other, ByteImage* image);

// Pixel (x, y) of the result is the maximum over the pixels [x * step, (x + 1) * step) x ... of
// `image`; step = 2^log2_step.
ByteImage BlockMaxima(const ByteImage& image, int log2_step);

// Pixel (x, y) of the result is the maximum over [x, x + window) x [y, y + window) of `image`;
// window >= 1. O(pixels * log(window)).
ByteImage SlidingMaxima(const ByteImage& image, int window);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_BYTE_IMAGE_H_
