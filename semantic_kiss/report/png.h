// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_PNG_H_
#define SEMANTIC_KISS_REPORT_PNG_H_

#include <cstdint>
#include <string>

namespace semantic_kiss::report {

// A picture with a palette, as PNG has it (https://www.w3.org/TR/png-3).
struct PalettePicture {
  int width = 0, height = 0;  // > 0 (CHECKed)
  int bits = 8;               // a pixel: 1, 2, 4 or 8
  std::string palette;        // red, green, blue of each entry
  std::string opacities;      // of each entry, 255: opaque
  std::string rows;           // packed, each with its filter type in front
};

// The bytes of the file. `effort` from 1 (fast) to 12 (small).
std::string PngFile(const PalettePicture& picture, int effort);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_PNG_H_
