// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_page.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/draw_legend.h"
#include "cartographer/io/draw_scale_bar.h"
#include "cartographer/io/draw_trajectory.h"

namespace cartographer::io {
namespace {

constexpr sensor::Color kPaper{255, 255, 255};
constexpr sensor::Color kInk{30, 30, 34};
constexpr sensor::Color kPaleInk{110, 110, 116};
constexpr sensor::Color kBorder{205, 204, 200};

// Lengths in pixels.
struct Layout {
  double em = 0.;  // height of letters
  MapPlacement map;
  double title_y = 0., facts_y = 0.;  // lines that letters stand on
  double legend_x = 0., legend_y = 0.;
  double bar_y = 0.;
  int width = 0, height = 0;
};

Layout PlainLayout(const RasterFrame& frame) {
  Layout layout;
  layout.em = std::clamp(std::max(frame.width, frame.height) / 70., 11., 80.);
  layout.map = {frame, 0, 0, std::max(1.5, 0.11 * layout.em)};
  layout.width = frame.width;
  layout.height = frame.height;
  return layout;
}

Layout FramedLayout(const RasterFrame& frame, bool has_title, const LegendSize& legend) {
  Layout layout = PlainLayout(frame);
  const double em = layout.em;
  layout.title_y = 2.2 * em;
  layout.facts_y = (has_title ? 3.9 : 2.0) * em;
  layout.map.x = static_cast<int>(std::ceil(1.2 * em));
  layout.map.y = static_cast<int>(std::ceil(layout.facts_y + 1.1 * em));
  layout.legend_x = layout.map.x + frame.width + 1.2 * em;
  layout.legend_y = layout.map.y;
  const double content = std::max<double>(frame.height, legend.height_px);
  layout.bar_y = layout.map.y + content + 2.9 * em;
  // What stands below the map needs as much, however small the map is.
  constexpr double kSmallestWidth = 27.;
  layout.width = static_cast<int>(
      std::ceil(std::max(layout.legend_x + legend.width_px + 1.2 * em, kSmallestWidth * em)));
  layout.height = static_cast<int>(std::ceil(layout.bar_y + 1.1 * em));
  return layout;
}

std::string Count(size_t count, absl::string_view noun) {
  return absl::StrCat(count, " ", noun, count == 1 ? "" : "s");
}

double DrivenLength_m(const map::Map& map) {
  double length_m = 0.;
  for (auto it = map.nodes.begin(); it != map.nodes.end(); ++it) {
    const auto next = std::next(it);
    if (next == map.nodes.end() || next->first.trajectory_id != it->first.trajectory_id) continue;
    const double step_m =
        (next->second.map_from_node.translation() - it->second.map_from_node.translation()).norm();
    if (std::isfinite(step_m)) length_m += step_m;
  }
  return length_m;
}

size_t NumLoopClosures(const map::Map& map) {
  return std::count_if(map.constraints.begin(), map.constraints.end(), [](const auto& constraint) {
    return constraint.kind == map::Constraint::Kind::kInterSubmap;
  });
}

// "16 scans, 11.7 m driven, 3 submaps, 2 loop closures"
std::string Facts(const map::Map& map) {
  std::string facts;
  if (!map.nodes.empty()) {
    absl::StrAppend(&facts, Count(map.nodes.size(), "scan"), ", ", LengthText(DrivenLength_m(map)),
                    " driven, ");
  }
  absl::StrAppend(&facts, Count(map.submaps.size(), "submap"));
  const size_t closures = NumLoopClosures(map);
  if (closures > 0) absl::StrAppend(&facts, ", ", Count(closures, "loop closure"));
  return facts;
}

std::vector<LegendEntry> EntriesOf(const map::Map& map, const proto::RenderOptions& options,
                                   const SemanticRaster& raster) {
  using Sample = LegendEntry::Sample;
  std::vector<LegendEntry> entries = LegendOf(raster, map.labels);
  if (options.draw_trajectory() && !map.nodes.empty()) {
    entries.push_back({Sample::kStart, kTrajectoryColor, "start"});
    entries.push_back({Sample::kLine, kTrajectoryColor, "trajectory"});
    entries.push_back({Sample::kEnd, kTrajectoryColor, "end"});
  }
  if (options.draw_loop_closures() && NumLoopClosures(map) > 0) {
    entries.push_back({Sample::kLine, kLoopClosureColor, "loop closure"});
  }
  return entries;
}

// Without the last character, were it of several bytes.
void RemoveLastCharacter(std::string* text) {
  const auto is_continued = [](char byte) { return (static_cast<uint8_t>(byte) & 0xc0) == 0x80; };
  while (!text->empty() && is_continued(text->back())) text->pop_back();
  if (!text->empty()) text->pop_back();
}

// Makes the letters smaller, then cuts the text, until it fits between x and the same at the right.
void DrawFitting(std::string text, double x, double y, TextStyle style, Canvas* canvas) {
  constexpr double kSmallest = 0.6;
  const double room = canvas->width() - 2. * x;
  const double width = canvas->TextWidth(text, style);
  if (width > room) style.size_px *= std::max(kSmallest, room / width);
  if (kSmallest * width > room) {
    while (!text.empty() && canvas->TextWidth(text + "...", style) > room) {
      RemoveLastCharacter(&text);
    }
    text += "...";
  }
  canvas->DrawText(text, x, y, style);
}

void DrawFrame(const Layout& layout, const map::Map& map, const std::string& title,
               Canvas* canvas) {
  const double em = layout.em, x = layout.map.x;
  if (!title.empty()) DrawFitting(title, x, layout.title_y, {1.5 * em, true, kInk}, canvas);
  DrawFitting(Facts(map), x, layout.facts_y, {em, false, title.empty() ? kInk : kPaleInk}, canvas);

  const RasterFrame& frame = layout.map.frame;
  cairo_rectangle(canvas->context(), x - 0.5, layout.map.y - 0.5, frame.width + 1.,
                  frame.height + 1.);
  canvas->SetColor(kBorder);
  cairo_set_line_width(canvas->context(), 1.);
  cairo_stroke(canvas->context());

  Anchor anchor{x, layout.bar_y, em};
  anchor.x += DrawAxes(anchor, canvas) + 1.5 * em;
  anchor.x +=
      DrawScaleBar(frame.resolution_m, std::max(4. * em, 0.2 * frame.width), anchor, canvas) +
      2. * em;
  canvas->DrawText(absl::StrCat("1 pixel = ", LengthText(frame.resolution_m)), anchor.x, anchor.y,
                   {em, false, kPaleInk});
}

}  // namespace

absl::StatusOr<Canvas> DrawPage(const map::Map& map, const proto::RenderOptions& options,
                                const SemanticRaster& raster, const std::vector<uint32_t>& pixels) {
  Layout layout = PlainLayout(raster.frame);
  std::vector<LegendEntry> entries;
  if (options.draw_frame()) {
    ASSIGN_OR_RETURN(Canvas scratch, Canvas::Create(1, 1, kPaper));
    entries = EntriesOf(map, options, raster);
    layout = FramedLayout(raster.frame, !options.title().empty(),
                          MeasureLegend(entries, layout.em, &scratch));
  }
  ASSIGN_OR_RETURN(Canvas canvas, Canvas::Create(layout.width, layout.height, kPaper));
  canvas.DrawPixels(pixels, raster.frame.width, layout.map.x, layout.map.y);
  if (options.draw_loop_closures()) DrawLoopClosures(map, layout.map, &canvas);
  if (options.draw_trajectory()) DrawTrajectories(map, layout.map, &canvas);
  if (options.draw_frame()) {
    DrawLegend(entries, layout.em, layout.legend_x, layout.legend_y, &canvas);
    DrawFrame(layout, map, options.title(), &canvas);
  }
  return canvas;
}

}  // namespace cartographer::io
