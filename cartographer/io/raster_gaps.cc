// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_gaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cartographer/common/parallel.h"

namespace cartographer::io {
namespace {

// The lines through the raster in one direction; every pixel is on exactly one of them.
struct Direction {
  int column, row;  // step from a pixel to the next
};

struct Line {
  size_t start;  // index of its first pixel
  int length;    // number of pixels
};

std::vector<Line> LinesOf(const SemanticRaster& raster, const Direction& direction) {
  const int width = raster.frame.width, height = raster.frame.height;
  std::vector<Line> lines;
  const auto add = [&](int column, int row) {
    const int to_side = direction.column > 0   ? width - column
                        : direction.column < 0 ? column + 1
                                               : height;
    const int to_bottom = direction.row > 0 ? height - row : width;
    lines.push_back({raster.IndexOf(column, row), std::min(to_side, to_bottom)});
  };
  if (direction.row > 0) {
    for (int column = 0; column < width; ++column) add(column, 0);
  }
  if (direction.column != 0) {
    const int side = direction.column > 0 ? 0 : width - 1;
    for (int row = direction.row > 0 ? 1 : 0; row < height; ++row) add(side, row);
  }
  return lines;
}

class GapFiller {
 public:
  GapFiller(const sensor::LabelMask& labels, SemanticRaster* raster)
      : labels_(labels), raster_(*raster), width_px_(raster->labels.size(), kNone) {}

  // Bridges the gaps of at most `limit_px` between pixels that are known at present.
  void Run(double limit_px) {
    known_.resize(raster_.labels.size());
    for (size_t i = 0; i < known_.size(); ++i) {
      known_[i] = raster_.hits[i] > 0.f || raster_.labels[i] != sensor::kUnlabeled;
    }
    for (const Direction& direction : {Direction{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
      const std::vector<Line> lines = LinesOf(raster_, direction);
      const size_t stride = direction.row * raster_.frame.width + direction.column;
      const double step_px = std::hypot(direction.column, direction.row);
      common::ParallelChunks(lines.size(), 64, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) BridgeLine(lines[i], stride, step_px, limit_px);
      });
    }
  }

 private:
  static constexpr float kNone = std::numeric_limits<float>::infinity();

  void BridgeLine(const Line& line, size_t stride, double step_px, double limit_px) {
    int last = -1;
    for (int step = 0; step < line.length; ++step) {
      const size_t index = line.start + step * stride;
      if (!known_[index]) continue;
      const sensor::Label label = raster_.labels[index];
      const double px = (step - last) * step_px;
      if (last >= 0 && px <= limit_px && labels_.Contains(label) &&
          label == raster_.labels[line.start + last * stride]) {
        for (int gap = last + 1; gap < step; ++gap) {
          Offer(line.start + gap * stride, label, static_cast<float>(px));
        }
      }
      last = step;
    }
  }

  void Offer(size_t index, sensor::Label label, float px) {
    if (px >= width_px_[index]) return;
    width_px_[index] = px;
    raster_.labels[index] = label;
  }

  const sensor::LabelMask& labels_;
  SemanticRaster& raster_;
  std::vector<float> width_px_;  // of the gap that gave an unseen pixel its label
  std::vector<char> known_;
};

}  // namespace

void FillGaps(const sensor::LabelMask& labels, double width_m, SemanticRaster* raster) {
  if (width_m <= 0.) return;
  GapFiller filler(labels, raster);
  for (int pass = 0; pass < 2; ++pass) filler.Run(width_m / raster->frame.resolution_m);
}

}  // namespace cartographer::io
