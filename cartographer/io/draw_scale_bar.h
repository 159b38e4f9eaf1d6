// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_DRAW_SCALE_BAR_H_
#define CARTOGRAPHER_IO_DRAW_SCALE_BAR_H_

#include <string>

#include "cartographer/io/draw_canvas.h"

namespace cartographer::io {

// The largest of 1, 2 and 5 times a power of ten that is at most `length_m` (> 0, CHECKed).
double RoundLength(double length_m);

// "5 cm", "2.5 m", "20 m", "1.25 km".
std::string LengthText(double length_m);

// Where to draw and how large: (x, y) is the lower left corner, `em_px` the height of letters.
struct Anchor {
  double x = 0., y = 0.;
  double em_px = 12.;
};

// Draws a bar of a round length up to `max_width_px` with the length beside it; returns the width
// that both take [px].
double DrawScaleBar(double resolution_m, double max_width_px, const Anchor& anchor, Canvas* canvas);

// Draws the map frame's axes as two arrows, x to the right and y up; returns their width [px].
double DrawAxes(const Anchor& anchor, Canvas* canvas);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_DRAW_SCALE_BAR_H_
