// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SCORE_LAYERS_H_
#define CARTOGRAPHER_SCAN_MATCHING_SCORE_LAYERS_H_

#include <vector>

#include "cartographer/scan_matching/byte_image.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::scan_matching {

// Cells farther than this from the grid's origin, along an axis, agree with nothing: a stray hit
// must not make the pyramid of a submap, whose hits are within a lidar's range, grow without bound.
inline constexpr int kMaxCell = 2048;

// How well a point of each layer of the model agrees with each cell of the grid, in steps of 1/255
// (score_model.h): an image for each layer, in cells. All have the columns of all hits that count
// together, and each the rows of its own. A layer without hits has no rows.
std::vector<ByteImage> ScoreLayers(const submap::SemanticGrid& grid, const ScoreModel& model);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SCORE_LAYERS_H_
