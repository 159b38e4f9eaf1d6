// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/byte_image.h"

#include <algorithm>

#include "glog/logging.h"

namespace cartographer::scan_matching {
namespace {

// target[i] = max(target[i], source[i]). `source` may be `target` plus a positive number: then what
// is read has not been written yet, which the compiler cannot see by itself.
void MaxRow(const uint8_t* source, size_t size, uint8_t* target) {
#pragma GCC ivdep
  for (size_t i = 0; i < size; ++i) target[i] = std::max(target[i], source[i]);
}

// Maxima over windows of 1 pixel are joined, step pixels apart, to such over twice as many, and so
// on; beyond the last pixel there are zeros.
template <typename JoinWindows>
void ForEachStep(int window, const JoinWindows& join_windows) {
  for (int done = 1; done < window;) {
    const int step = std::min(done, window - done);
    join_windows(step);
    done += step;
  }
}

}  // namespace

void MaxInto(const ByteImage& other, ByteImage* image) {
  CHECK(other.x0 >= image->x0 && other.x0 + other.width <= image->x0 + image->width);
  CHECK(other.y0 >= image->y0 && other.y0 + other.height <= image->y0 + image->height);
  for (int y = other.y0; y < other.y0 + other.height; ++y) {
    MaxRow(other.Row(y), other.width, image->Row(y) + (other.x0 - image->x0));
  }
}

ByteImage BlockMaxima(const ByteImage& image, int log2_step) {
  const int x0 = image.x0 >> log2_step, y0 = image.y0 >> log2_step;
  const int x1 = (image.x0 + image.width - 1) >> log2_step;
  const int y1 = (image.y0 + image.height - 1) >> log2_step;
  ByteImage result(x0, y0, x1 - x0 + 1, y1 - y0 + 1);
  std::vector<uint8_t> row(image.width);
  for (int y = y0; y <= y1; ++y) {
    std::fill(row.begin(), row.end(), 0);
    const int begin = std::max(y << log2_step, image.y0);
    const int end = std::min((y + 1) << log2_step, image.y0 + image.height);
    for (int source = begin; source < end; ++source) {
      MaxRow(image.Row(source), image.width, row.data());
    }
    uint8_t* const target = result.Row(y);
    for (int x = 0; x < image.width; ++x) {
      uint8_t& pixel = target[((image.x0 + x) >> log2_step) - x0];
      pixel = std::max(pixel, row[x]);
    }
  }
  return result;
}

ByteImage SlidingMaxima(const ByteImage& image, int window) {
  CHECK_GE(window, 1);
  const int margin = window - 1;
  ByteImage result(image.x0 - margin, image.y0 - margin, image.width + margin,
                   image.height + margin);
  for (int y = image.y0; y < image.y0 + image.height; ++y) {
    uint8_t* const row = result.Row(y);
    std::copy_n(image.Row(y), image.width, row + margin);
    ForEachStep(window, [&](int step) { MaxRow(row + step, result.width - step, row); });
  }
  ForEachStep(window, [&](int step) {
    const size_t size = size_t(result.height - step) * result.width;
    MaxRow(result.bytes.data() + size_t(step) * result.width, size, result.bytes.data());
  });
  return result;
}

}  // namespace cartographer::scan_matching
