// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_trajectory.h"

#include <cmath>
#include <vector>

namespace cartographer::io {
namespace {

constexpr sensor::Color kSeamColor{255, 255, 255};
constexpr double kSeam = 1.9;  // widths of the line
constexpr double kMarkRadius = 1.8;

using Line = std::vector<Eigen::Vector2d>;

Eigen::Vector2d OnCanvas(const MapPlacement& placement, const Eigen::Vector3d& position) {
  return placement.frame.PixelFromMap(position.head<2>()) +
         Eigen::Vector2d(placement.x, placement.y);
}

// One line per trajectory.
std::vector<Line> LinesOf(const map::Map& map, const MapPlacement& placement) {
  std::vector<Line> lines;
  int trajectory_id = 0;
  for (const auto& [id, node] : map.nodes) {
    if (!node.map_from_node.IsFinite()) continue;
    if (lines.empty() || id.trajectory_id != trajectory_id) lines.emplace_back();
    trajectory_id = id.trajectory_id;
    lines.back().push_back(OnCanvas(placement, node.map_from_node.translation()));
  }
  return lines;
}

void Stroke(const Line& line, double width, Canvas* canvas) {
  cairo_t* context = canvas->context();
  for (const Eigen::Vector2d& point : line) cairo_line_to(context, point.x(), point.y());
  cairo_set_line_width(context, width);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_stroke(context);
}

void FillDisc(double x, double y, double radius, Canvas* canvas) {
  cairo_arc(canvas->context(), x, y, radius, 0., 2. * M_PI);
  cairo_fill(canvas->context());
}

// Nothing may be drawn beside the map.
void ClipToMap(const MapPlacement& placement, Canvas* canvas) {
  cairo_rectangle(canvas->context(), placement.x, placement.y, placement.frame.width,
                  placement.frame.height);
  cairo_clip(canvas->context());
}

}  // namespace

void DrawStartMark(double x, double y, double line_px, Canvas* canvas) {
  canvas->SetColor(kSeamColor);
  FillDisc(x, y, (kMarkRadius + 0.9) * line_px, canvas);
  canvas->SetColor(kTrajectoryColor);
  FillDisc(x, y, (kMarkRadius + 0.45) * line_px, canvas);
  canvas->SetColor(kSeamColor);
  FillDisc(x, y, (kMarkRadius - 0.55) * line_px, canvas);
}

void DrawEndMark(double x, double y, double line_px, Canvas* canvas) {
  canvas->SetColor(kSeamColor);
  FillDisc(x, y, (kMarkRadius + 0.9) * line_px, canvas);
  canvas->SetColor(kTrajectoryColor);
  FillDisc(x, y, (kMarkRadius + 0.45) * line_px, canvas);
}

void DrawTrajectories(const map::Map& map, const MapPlacement& placement, Canvas* canvas) {
  const std::vector<Line> lines = LinesOf(map, placement);
  cairo_save(canvas->context());
  ClipToMap(placement, canvas);
  canvas->SetColor(kSeamColor, 0.85);
  for (const Line& line : lines) Stroke(line, kSeam * placement.line_px, canvas);
  canvas->SetColor(kTrajectoryColor);
  for (const Line& line : lines) Stroke(line, placement.line_px, canvas);
  for (const Line& line : lines) {
    DrawStartMark(line.front().x(), line.front().y(), placement.line_px, canvas);
    DrawEndMark(line.back().x(), line.back().y(), placement.line_px, canvas);
  }
  cairo_restore(canvas->context());
}

void DrawLoopClosures(const map::Map& map, const MapPlacement& placement, Canvas* canvas) {
  cairo_save(canvas->context());
  ClipToMap(placement, canvas);
  canvas->SetColor(kLoopClosureColor, 0.6);
  for (const map::Constraint& constraint : map.constraints) {
    if (constraint.kind != map::Constraint::Kind::kInterSubmap) continue;
    const auto node = map.nodes.find(constraint.node_id);
    const auto submap = map.submaps.find(constraint.submap_id);
    if (node == map.nodes.end() || submap == map.submaps.end()) continue;
    if (!node->second.map_from_node.IsFinite()) continue;
    Stroke({OnCanvas(placement, node->second.map_from_node.translation()),
            OnCanvas(placement, submap->second.map_from_submap.translation())},
           0.5 * placement.line_px, canvas);
  }
  cairo_restore(canvas->context());
}

}  // namespace cartographer::io
