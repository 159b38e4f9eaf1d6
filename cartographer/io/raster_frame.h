// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RASTER_FRAME_H_
#define CARTOGRAPHER_IO_RASTER_FRAME_H_

#include <Eigen/Core>
#include <cstddef>

#include "absl/status/statusor.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label.h"

namespace cartographer::io {

// How an image lies in the map frame, seen from above: x grows with the column, y against the row,
// so that row 0 is the edge with the largest y, as in image files. Pixel (column, row) covers
//   [min_x + column * r, ... + r) x (max_y - (row + 1) * r, ... + r], r = resolution_m.
struct RasterFrame {
  double resolution_m = 0.;  // side of a pixel, > 0
  double min_x = 0.;         // [m], map frame: left edge of column 0
  double max_y = 0.;         // [m], map frame: upper edge of row 0
  int width = 0;             // columns
  int height = 0;            // rows

  size_t size() const { return static_cast<size_t>(width) * height; }

  // Continuous image coordinates: pixel (column, row) covers [column, column + 1) x [row, row + 1).
  Eigen::Vector2d PixelFromMap(const Eigen::Vector2d& position_m) const {
    return {(position_m.x() - min_x) / resolution_m, (max_y - position_m.y()) / resolution_m};
  }
  Eigen::Vector2d MapFromPixel(const Eigen::Vector2d& pixel) const {
    return {min_x + pixel.x() * resolution_m, max_y - pixel.y() * resolution_m};
  }
};

struct RasterFrameOptions {
  double resolution_m = 0.;  // 0: the finest grid's, halved
  int max_side_px = 4000;    // coarsens the resolution until both sides fit
  // Share of the occupied tiles that may fall outside on each of the four sides: far, lone returns
  // would otherwise leave a picture of mostly nothing. 0: everything is inside. The trajectories
  // are always inside.
  double crop_share = 0.;
};

// Side of a cell of the finest grid; infinity if there are none.
double FinestResolution_m(const map::Map& map);

// The frame that shows what the map's grids saw of all labels but `hidden`; unlabeled hits count
// only if there are no others. Errors: a map without a single hit that is shown, a submap's pose
// that is not finite, extents that overflow.
absl::StatusOr<RasterFrame> FrameOf(const map::Map& map, const sensor::LabelMask& hidden,
                                    const RasterFrameOptions& options);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RASTER_FRAME_H_
