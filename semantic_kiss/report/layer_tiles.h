// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_LAYER_TILES_H_
#define SEMANTIC_KISS_REPORT_LAYER_TILES_H_

#include <string>
#include <vector>

#include "semantic_kiss/report/alpha_image.h"

namespace semantic_kiss::report {

// A square piece of a picture. Its upper left pixel is (column, row) * side of the picture halved
// `level` times, so that a viewer loads few pieces however far it is away.
struct LayerTile {
  int level = 0;
  int column = 0;
  int row = 0;
  std::string png;
};

// How often a picture of that size is halved until its longer side fits into two tiles.
int NumHalvings(int width, int height, int tile_side);

// Cuts `image` and its first `halvings` halves into tiles, without those that would be empty.
// Levels come in order, tiles of a level row by row. Parallel; the result does not depend on it.
std::vector<LayerTile> CutIntoTiles(AlphaImage image, int halvings, int tile_side, const Ink& ink);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_LAYER_TILES_H_
