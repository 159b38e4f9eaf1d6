// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_IO_DECODED_PNG_H_
#define TEST_CARTOGRAPHER_IO_DECODED_PNG_H_

#include <cstdint>
#include <string>
#include <vector>

namespace cartographer::io {

// A PNG file's pixels: 0xffRRGGBB, row by row.
struct DecodedPng {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;
  uint32_t At(int x, int y) const { return pixels.at(static_cast<size_t>(y) * width + x); }
};

// CHECK-fails for bytes that are no PNG file.
DecodedPng DecodePng(const std::string& bytes);

}  // namespace cartographer::io

#endif  // TEST_CARTOGRAPHER_IO_DECODED_PNG_H_
