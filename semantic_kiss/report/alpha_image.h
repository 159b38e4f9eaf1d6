// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_ALPHA_IMAGE_H_
#define SEMANTIC_KISS_REPORT_ALPHA_IMAGE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cartographer/sensor/label_set.h"

namespace semantic_kiss::report {

// The most opaque pixel of an AlphaImage.
inline constexpr int kOpaque = 15;

// An image of one colour: how much of it each pixel has, from 0 (none) to kOpaque. Rows lie one
// after another, the topmost first.
struct AlphaImage {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> levels;

  AlphaImage() = default;
  AlphaImage(int width, int height)
      : width(width), height(height), levels(static_cast<size_t>(width) * height) {}

  uint8_t* Row(int row) { return levels.data() + static_cast<size_t>(row) * width; }
  const uint8_t* Row(int row) const { return levels.data() + static_cast<size_t>(row) * width; }
};

// The square of `side` pixels whose upper left one is (column, row), empty beyond the image's edge.
AlphaImage CutOut(const AlphaImage& image, int column, int row, int side);

// Half as large, rounded up: four pixels become one, halfway between their mean and the strongest
// of them, so that thin lines outlast several halvings and broad areas still soften.
AlphaImage Halved(const AlphaImage& image);

bool IsEmpty(const AlphaImage& image);

// What an image is drawn with: its colour, and the opacity in [0, 1] of a pixel of kOpaque.
struct Ink {
  cartographer::sensor::Color color;
  double opacity = 1.;
};

// The bytes of a PNG file with a palette of 16 entries, so four bits a pixel. The image must not be
// of size 0 (CHECKed).
std::string ToPng(const AlphaImage& image, const Ink& ink);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_ALPHA_IMAGE_H_
