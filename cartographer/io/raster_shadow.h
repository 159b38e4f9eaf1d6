// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RASTER_SHADOW_H_
#define CARTOGRAPHER_IO_RASTER_SHADOW_H_

#include <vector>

#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label.h"

namespace cartographer::io {

// The shadows that the clouds' points cast on the ground under a high sun in the upper left: what
// makes facades, cars and trees stand out from what is flat. Points with a ground label, unlabeled
// ones and those in `hidden` cast none. Returns the depth of shadow of every pixel, 0 (lit) to 1,
// row by row; nothing but 0 if no cloud has a point with a ground label.
std::vector<float> CastShadows(const map::Map& map, const sensor::LabelMask& hidden,
                               const RasterFrame& frame);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RASTER_SHADOW_H_
