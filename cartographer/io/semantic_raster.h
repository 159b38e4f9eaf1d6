// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_SEMANTIC_RASTER_H_
#define CARTOGRAPHER_IO_SEMANTIC_RASTER_H_

#include <cstddef>
#include <vector>

#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label.h"

namespace cartographer::io {

// The world from above: all submaps' grids, placed by their poses and summed, as one image. Rows
// lie one after another; every column below has frame.size() entries.
struct SemanticRaster {
  RasterFrame frame;
  // The label with the most hits of all submaps (the smaller label on ties; kUnlabeled only where
  // no other label was hit).
  std::vector<sensor::Label> labels;
  // Hits of that label; 0: nothing was ever seen here. Where a pixel is smaller than a grid's cell
  // it gets its share of the cell's hits by area, so sums over an area don't depend on resolution.
  std::vector<float> hits;

  size_t IndexOf(int column, int row) const {
    return static_cast<size_t>(row) * frame.width + column;
  }
};

// Draws nothing of the labels in `hidden`: what lay beneath them shows. Roll and pitch of submaps'
// poses are ignored. Where pixels are not much larger than cells, every pixel looks up the cell
// below its center, so that rotated submaps show no holes; where they are larger, every cell adds
// its hits to the pixel below its center. Runs in parallel; the result does not depend on it.
SemanticRaster ComposeRaster(const map::Map& map, const sensor::LabelMask& hidden,
                             const RasterFrame& frame);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_SEMANTIC_RASTER_H_
