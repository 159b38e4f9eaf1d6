// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_legend.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "absl/strings/str_replace.h"
#include "cartographer/io/draw_trajectory.h"
#include "cartographer/io/raster_shading.h"

namespace cartographer::io {
namespace {

// In units of the letters' height.
constexpr double kRowHeight = 1.6;
constexpr double kSampleWidth = 1.5;
constexpr double kSampleHeight = 0.9;
constexpr double kTextStart = 2.0;
constexpr sensor::Color kTextColor{45, 45, 48};

TextStyle StyleOf(double em_px) { return {em_px, false, kTextColor}; }

void DrawArea(const LegendEntry& entry, double em_px, double x, double y, Canvas* canvas) {
  cairo_rectangle(canvas->context(), x, y - 0.5 * kSampleHeight * em_px, kSampleWidth * em_px,
                  kSampleHeight * em_px);
  canvas->SetColor(entry.color);
  cairo_fill_preserve(canvas->context());
  canvas->SetColor({0, 0, 0}, 0.25);
  cairo_set_line_width(canvas->context(), 0.05 * em_px);
  cairo_stroke(canvas->context());
}

void DrawMark(const LegendEntry& entry, double em_px, double x, double y, Canvas* canvas) {
  cairo_arc(canvas->context(), x + 0.5 * kSampleWidth * em_px, y, 0.32 * em_px, 0., 2. * M_PI);
  canvas->SetColor(entry.color);
  cairo_fill_preserve(canvas->context());
  canvas->SetColor(kRimColor);
  cairo_set_line_width(canvas->context(), 0.14 * em_px);
  cairo_stroke(canvas->context());
}

void DrawLine(const LegendEntry& entry, double em_px, double x, double y, Canvas* canvas) {
  cairo_move_to(canvas->context(), x, y);
  cairo_line_to(canvas->context(), x + kSampleWidth * em_px, y);
  canvas->SetColor(entry.color);
  cairo_set_line_width(canvas->context(), 0.16 * em_px);
  cairo_stroke(canvas->context());
}

// Draws the sample with its left edge at x, centered on y.
void DrawSample(const LegendEntry& entry, double em_px, double x, double y, Canvas* canvas) {
  const double middle = x + 0.5 * kSampleWidth * em_px;
  switch (entry.sample) {
    case LegendEntry::Sample::kArea:
      return DrawArea(entry, em_px, x, y, canvas);
    case LegendEntry::Sample::kMark:
      return DrawMark(entry, em_px, x, y, canvas);
    case LegendEntry::Sample::kLine:
      return DrawLine(entry, em_px, x, y, canvas);
    case LegendEntry::Sample::kStart:
      return DrawStartMark(middle, y, 0.2 * em_px, canvas);
    case LegendEntry::Sample::kEnd:
      return DrawEndMark(middle, y, 0.2 * em_px, canvas);
  }
}

}  // namespace

std::vector<LegendEntry> LegendOf(const SemanticRaster& raster, const sensor::LabelSet& labels) {
  std::vector<int64_t> areas(labels.size());
  for (size_t i = 0; i < raster.labels.size(); ++i) {
    const bool seen = raster.hits[i] > 0.f;
    if (seen || raster.labels[i] != sensor::kUnlabeled) ++areas[sensor::Index(raster.labels[i])];
  }
  std::vector<sensor::Label> order;
  for (size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] > 0) order.push_back(sensor::Label{static_cast<uint8_t>(i)});
  }
  std::sort(order.begin(), order.end(), [&](sensor::Label a, sensor::Label b) {
    const bool a_last = a == sensor::kUnlabeled, b_last = b == sensor::kUnlabeled;
    if (a_last != b_last) return b_last;
    const int64_t area_a = areas[sensor::Index(a)], area_b = areas[sensor::Index(b)];
    return area_a != area_b ? area_a > area_b : a < b;
  });
  std::vector<LegendEntry> entries;
  for (const sensor::Label label : order) {
    if (label == sensor::kUnlabeled) {
      entries.push_back(
          {LegendEntry::Sample::kArea, UnlabeledColor(!entries.empty()), labels.Name(label)});
      continue;
    }
    const bool critical = labels.HasRole(label, sensor::LabelRole::kCritical);
    entries.push_back({critical ? LegendEntry::Sample::kMark : LegendEntry::Sample::kArea,
                       BaseColor(labels, label),
                       absl::StrReplaceAll(labels.Name(label), {{"-", " "}, {"_", " "}})});
  }
  return entries;
}

LegendSize MeasureLegend(const std::vector<LegendEntry>& entries, double em_px, Canvas* canvas) {
  LegendSize size;
  for (const LegendEntry& entry : entries) {
    const double text_px = canvas->TextWidth(entry.text, StyleOf(em_px));
    size.width_px = std::max(size.width_px, kTextStart * em_px + text_px);
  }
  size.height_px = entries.size() * kRowHeight * em_px;
  return size;
}

void DrawLegend(const std::vector<LegendEntry>& entries, double em_px, double x, double y,
                Canvas* canvas) {
  double middle = y + 0.5 * kRowHeight * em_px;
  for (const LegendEntry& entry : entries) {
    DrawSample(entry, em_px, x, middle, canvas);
    canvas->DrawText(entry.text, x + kTextStart * em_px, middle + 0.35 * em_px, StyleOf(em_px));
    middle += kRowHeight * em_px;
  }
}

}  // namespace cartographer::io
