// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/scan_preview.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/draw_canvas.h"
#include "glog/logging.h"

namespace semantic_kiss::simulation {
namespace {

using cartographer::io::Canvas;
using cartographer::sensor::Color;
using cartographer::sensor::Label;
using cartographer::sensor::LabelSet;

constexpr int kWidth = 1075;
constexpr int kPanelHeight = 192;
constexpr int kGap = 6;
constexpr double kFarthest_m = 60.;

using Coloring = std::function<Color(const SimulatedPoint&)>;

uint32_t Opaque(const Color& color) {
  return 0xff000000u | uint32_t{color.red} << 16 | uint32_t{color.green} << 8 | color.blue;
}

Color Grey(double brightness) {
  const auto value = static_cast<uint8_t>(std::lround(255. * std::clamp(brightness, 0., 1.)));
  return {value, value, value};
}

// Columns turn to the left from behind the car; in the picture the left side is on the left.
std::vector<uint32_t> Panel(const SimulatedScan& points, const Lidar& lidar,
                            const Coloring& color) {
  std::vector<uint32_t> pixels(size_t{kWidth} * kPanelHeight, Opaque(Color{}));
  const int rows_per_beam = std::max(1, kPanelHeight / lidar.beams());
  for (const SimulatedPoint& point : points) {
    const int x = kWidth - 1 - point.column * kWidth / lidar.columns();
    const int end = (kWidth + lidar.columns() - 1) / lidar.columns();
    const int top = point.beam * kPanelHeight / lidar.beams();
    const uint32_t pixel = Opaque(color(point));
    for (int row = top; row < std::min(kPanelHeight, top + rows_per_beam); ++row) {
      for (int i = 0; i < end && x - i >= 0; ++i) pixels[size_t{kWidth} * row + x - i] = pixel;
    }
  }
  return pixels;
}

}  // namespace

absl::Status DrawScanPreview(const Simulation& simulation, int scan, const LabelSet& labels,
                             const std::string& path) {
  CHECK(scan >= 0 && scan < simulation.num_scans()) << scan;
  const SimulatedScan points = simulation.Scan(scan);
  const Coloring colorings[] = {
      [&](const SimulatedPoint& point) {
        const std::optional<Label> label = labels.FromFileId(point.label);
        return label ? labels.ColorOf(*label) : Color{128, 128, 128};
      },
      // The root makes the near part, where most points are, easier to read.
      [](const SimulatedPoint& point) {
        return Grey(1.05 - std::sqrt(point.position.norm() / kFarthest_m));
      },
      [](const SimulatedPoint& point) { return Grey(0.1 + 0.9 * point.remission); }};
  constexpr int kNumPanels = 3;
  ASSIGN_OR_RETURN(Canvas canvas, Canvas::Create(kWidth, kNumPanels * (kPanelHeight + kGap) - kGap,
                                                 Color{255, 255, 255}));
  for (int i = 0; i < kNumPanels; ++i) {
    canvas.DrawPixels(Panel(points, simulation.lidar(), colorings[i]), kWidth, 0,
                      i * (kPanelHeight + kGap));
  }
  ASSIGN_OR_RETURN(const std::string png, canvas.ToPng());
  return cartographer::io::WriteFileAtomically(path, png);
}

}  // namespace semantic_kiss::simulation
