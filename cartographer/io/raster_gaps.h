// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RASTER_GAPS_H_
#define CARTOGRAPHER_IO_RASTER_GAPS_H_

#include "cartographer/io/semantic_raster.h"
#include "cartographer/sensor/label.h"

namespace cartographer::io {

// Fills what lies between the rings that a lidar draws on the ground. A pixel without hits gets
// label L of `labels` if, along its row, its column or a diagonal, the nearest seen pixels on both
// sides have label L and lie at most `width_m` apart, from center to center; the direction with the
// closest pair decides. A second pass over the result closes the meshes that the first one leaves.
//
// So nothing grows beyond what was seen, and nothing is filled across another label. Filled pixels
// keep 0 hits: that tells them from seen ones. Runs in parallel; the result does not depend on it.
void FillGaps(const sensor::LabelMask& labels, double width_m, SemanticRaster* raster);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RASTER_GAPS_H_
