// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_scale_bar.h"

#include <cmath>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

constexpr sensor::Color kInk{45, 45, 48};

// In units of the letters' height.
constexpr double kArrowLength = 1.9;
constexpr double kHeadLength = 0.45;

// An arrow from `tail` in direction (dx, dy), a unit vector.
void DrawArrow(const Anchor& tail, double dx, double dy, Canvas* canvas) {
  cairo_t* context = canvas->context();
  const double length = kArrowLength * tail.em_px, head = kHeadLength * tail.em_px;
  const double tip_x = tail.x + length * dx, tip_y = tail.y + length * dy;
  cairo_move_to(context, tail.x, tail.y);
  cairo_line_to(context, tip_x - head * dx, tip_y - head * dy);
  cairo_stroke(context);
  cairo_move_to(context, tip_x, tip_y);
  cairo_line_to(context, tip_x - head * (dx + 0.5 * dy), tip_y - head * (dy + 0.5 * dx));
  cairo_line_to(context, tip_x - head * (dx - 0.5 * dy), tip_y - head * (dy - 0.5 * dx));
  cairo_close_path(context);
  cairo_fill(context);
}

}  // namespace

double RoundLength(double length_m) {
  CHECK_GT(length_m, 0.);
  const double power = std::pow(10., std::floor(std::log10(length_m)));
  // The margin keeps a length that is round already from losing a step to round-off.
  const double digits = length_m / power * (1. + 1e-9);
  if (digits >= 10.) return 10. * power;
  return (digits >= 5. ? 5. : digits >= 2. ? 2. : 1.) * power;
}

std::string LengthText(double length_m) {
  if (length_m < 1.) return absl::StrFormat("%.3g cm", 100. * length_m);
  if (length_m < 1000.) return absl::StrFormat("%.3g m", length_m);
  if (length_m < 1e6) return absl::StrFormat("%.3g km", 1e-3 * length_m);
  return absl::StrFormat("%.0f km", 1e-3 * length_m);
}

double DrawScaleBar(double resolution_m, double max_width_px, const Anchor& anchor,
                    Canvas* canvas) {
  const double length_m = RoundLength(max_width_px * resolution_m);
  const double width = length_m / resolution_m;
  const double tick = 0.35 * anchor.em_px;
  cairo_t* context = canvas->context();
  canvas->SetColor(kInk);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_SQUARE);
  cairo_set_line_width(context, 0.14 * anchor.em_px);
  cairo_move_to(context, anchor.x, anchor.y - tick);
  cairo_line_to(context, anchor.x, anchor.y);
  cairo_line_to(context, anchor.x + width, anchor.y);
  cairo_line_to(context, anchor.x + width, anchor.y - tick);
  cairo_stroke(context);
  const std::string text = LengthText(length_m);
  const TextStyle style{anchor.em_px, false, kInk};
  const double gap = 0.6 * anchor.em_px;
  canvas->DrawText(text, anchor.x + width + gap, anchor.y, style);
  return width + gap + canvas->TextWidth(text, style);
}

double DrawAxes(const Anchor& anchor, Canvas* canvas) {
  const double em = anchor.em_px;
  canvas->SetColor(kInk);
  cairo_set_line_cap(canvas->context(), CAIRO_LINE_CAP_SQUARE);
  cairo_set_line_width(canvas->context(), 0.12 * em);
  DrawArrow(anchor, 1., 0., canvas);
  DrawArrow(anchor, 0., -1., canvas);
  const TextStyle style{0.9 * em, false, kInk};
  canvas->DrawText("x", anchor.x + (kArrowLength + 0.2) * em, anchor.y + 0.2 * em, style);
  canvas->DrawText("y", anchor.x + 0.35 * em, anchor.y - (kArrowLength - 0.5) * em, style);
  return (kArrowLength + 1.) * em;
}

}  // namespace cartographer::io
