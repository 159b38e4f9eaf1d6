// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_DRAW_LEGEND_H_
#define CARTOGRAPHER_IO_DRAW_LEGEND_H_

#include <string>
#include <vector>

#include "cartographer/io/draw_canvas.h"
#include "cartographer/io/semantic_raster.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::io {

// A line of the legend: a sample of what it explains, then words.
struct LegendEntry {
  enum class Sample { kArea, kMark, kStart, kEnd, kLine };
  Sample sample = Sample::kArea;
  sensor::Color color;
  std::string text;
};

// The labels that a raster shows, filled gaps included, from the largest area to the smallest (then
// by label): "traffic-sign" reads "traffic sign". Unlabeled hits come last.
std::vector<LegendEntry> LegendOf(const SemanticRaster& raster, const sensor::LabelSet& labels);

// Size of a legend whose letters are `em_px` high.
struct LegendSize {
  double width_px = 0., height_px = 0.;
};
LegendSize MeasureLegend(const std::vector<LegendEntry>& entries, double em_px, Canvas* canvas);

// Draws a legend with its upper left corner at (x, y).
void DrawLegend(const std::vector<LegendEntry>& entries, double em_px, double x, double y,
                Canvas* canvas);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_DRAW_LEGEND_H_
