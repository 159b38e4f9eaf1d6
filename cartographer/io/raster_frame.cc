// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/parallel.h"
#include "cartographer/common/status.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

using submap::SemanticGrid;

// One coordinate of the tiles' centers of all submaps.
struct TileCenters {
  std::vector<double> x, y;
  double half_diagonal_m = 0.;  // of the largest tile
};

TileCenters CentersOf(const map::MapSubmap& placed, const sensor::LabelMask& hidden) {
  TileCenters centers;
  const SemanticGrid& grid = placed.submap->grid;
  const transform::Rigid3d map_from_grid = transform::Level(placed.map_from_submap);
  const double tile_m = SemanticGrid::kTileSize * grid.resolution_m();
  for (const sensor::Label label : grid.Labels()) {
    if (hidden.Contains(label)) continue;
    for (const auto& [index, tile] : grid.LayerOf(label)) {
      const Eigen::Vector3d center =
          map_from_grid * Eigen::Vector3d((index.x + 0.5) * tile_m, (index.y + 0.5) * tile_m, 0.);
      centers.x.push_back(center.x());
      centers.y.push_back(center.y());
    }
  }
  centers.half_diagonal_m = tile_m * std::sqrt(0.5);
  return centers;
}

TileCenters CentersOf(const map::Map& map, const sensor::LabelMask& hidden) {
  std::vector<const map::MapSubmap*> submaps;
  for (const auto& entry : map.submaps) submaps.push_back(&entry.second);
  const std::vector<TileCenters> parts = common::ParallelMapChunks<TileCenters>(
      submaps.size(), 1, [&](size_t i, size_t) { return CentersOf(*submaps[i], hidden); });
  TileCenters all;
  for (const TileCenters& part : parts) {
    all.x.insert(all.x.end(), part.x.begin(), part.x.end());
    all.y.insert(all.y.end(), part.y.begin(), part.y.end());
    all.half_diagonal_m = std::max(all.half_diagonal_m, part.half_diagonal_m);
  }
  return all;
}

struct Interval {
  double min, max;
  void Add(double value, double margin) {
    min = std::min(min, value - margin);
    max = std::max(max, value + margin);
  }
  double Length() const { return max - min; }
};

// The values without the share `crop` of them at either end.
Interval InnerRange(std::vector<double> values, double crop) {
  const size_t cut = std::min(static_cast<size_t>(values.size() * crop), (values.size() - 1) / 2);
  const auto low = values.begin() + cut;
  const auto high = values.end() - 1 - cut;
  std::nth_element(values.begin(), low, values.end());
  const double min = *low;
  std::nth_element(low, high, values.end());
  return {min, *high};
}

// Widens the intervals so that all nodes are inside with some room around them.
void AddTrajectories(const map::Map& map, Interval* x, Interval* y) {
  constexpr double kMargin = 0.1;  // of the longer side of the box around all nodes
  constexpr double kMinMargin_m = 3., kMaxMargin_m = 20.;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Interval nodes_x{kInfinity, -kInfinity}, nodes_y{kInfinity, -kInfinity};
  for (const auto& [id, node] : map.nodes) {
    if (!node.map_from_node.IsFinite()) continue;
    nodes_x.Add(node.map_from_node.translation().x(), 0.);
    nodes_y.Add(node.map_from_node.translation().y(), 0.);
  }
  if (nodes_x.min > nodes_x.max) return;
  const double margin_m = std::clamp(kMargin * std::max(nodes_x.Length(), nodes_y.Length()),
                                     kMinMargin_m, kMaxMargin_m);
  x->Add(nodes_x.min, margin_m), x->Add(nodes_x.max, margin_m);
  y->Add(nodes_y.min, margin_m), y->Add(nodes_y.max, margin_m);
}

absl::Status CheckPoses(const map::Map& map) {
  for (const auto& [id, placed] : map.submaps) {
    if (placed.map_from_submap.IsFinite()) continue;
    return absl::InvalidArgumentError(absl::StrCat("submap ", id.trajectory_id, "/",
                                                   id.submap_index,
                                                   " of the map has a pose that is not finite"));
  }
  return absl::OkStatus();
}

}  // namespace

double FinestResolution_m(const map::Map& map) {
  double finest_m = std::numeric_limits<double>::infinity();
  for (const auto& [id, placed] : map.submaps) {
    finest_m = std::min(finest_m, placed.submap->grid.resolution_m());
  }
  return finest_m;
}

absl::StatusOr<RasterFrame> FrameOf(const map::Map& map, const sensor::LabelMask& hidden,
                                    const RasterFrameOptions& options) {
  CHECK_GE(options.resolution_m, 0.);
  CHECK_GT(options.max_side_px, 0);
  RETURN_IF_ERROR(CheckPoses(map));
  // Unlabeled hits are mostly far away; they matter only where there is nothing else.
  sensor::LabelMask unwanted = hidden;
  unwanted.Insert(sensor::kUnlabeled);
  TileCenters centers = CentersOf(map, unwanted);
  if (centers.x.empty()) centers = CentersOf(map, hidden);
  if (centers.x.empty()) {
    return absl::FailedPreconditionError(
        hidden.Empty() ? "the map has nothing to draw: none of its submaps' grids has a hit"
                       : "the map has nothing to draw: no grid has a hit of a label that is shown");
  }
  Interval x = InnerRange(centers.x, options.crop_share);
  Interval y = InnerRange(centers.y, options.crop_share);
  x.Add(x.min, centers.half_diagonal_m), x.Add(x.max, centers.half_diagonal_m);
  y.Add(y.min, centers.half_diagonal_m), y.Add(y.max, centers.half_diagonal_m);
  AddTrajectories(map, &x, &y);
  RasterFrame frame;
  const double wanted_m =
      options.resolution_m > 0. ? options.resolution_m : 0.5 * FinestResolution_m(map);
  const double longest_m = std::max(x.Length(), y.Length());
  if (!std::isfinite(longest_m)) {
    return absl::InvalidArgumentError("the map's submaps are farther apart than numbers can tell");
  }
  frame.resolution_m = std::max(wanted_m, longest_m / options.max_side_px);
  const auto pixels = [&](const Interval& side) {
    const double count = std::ceil(side.Length() / frame.resolution_m);
    return static_cast<int>(std::clamp<double>(count, 1., options.max_side_px));
  };
  frame.width = pixels(x);
  frame.height = pixels(y);
  frame.min_x = x.min;
  frame.max_y = y.max;
  return frame;
}

}  // namespace cartographer::io
