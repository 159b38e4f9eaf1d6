// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/matching_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace cartographer::scan_matching {
namespace {

// Fine enough that points in one cell of any usual grid are near each other on the curve.
constexpr float kCurveStep_m = 0.1f;
constexpr int64_t kMaxTotalWeight =
    std::numeric_limits<int32_t>::max() / ScoreModel::kFullAgreement;

// The bits of `value` moved apart, so that those of another number fit in between.
uint64_t SpreadBits(uint32_t value) {
  uint64_t bits = value;
  bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
  bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
  bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
  bits = (bits | bits << 2) & 0x3333333333333333u;
  return (bits | bits << 1) & 0x5555555555555555u;
}

// Place along a Z-shaped curve through the plane; |coordinates| <= 1000 m, as options bound them.
uint64_t PlaceOnCurve(const Eigen::Vector2f& position) {
  constexpr float kOffset = 1 << 20;
  const auto step = [](float x) { return static_cast<uint32_t>(x / kCurveStep_m + kOffset); };
  return SpreadBits(step(position.y())) << 1 | SpreadBits(step(position.x()));
}

// std::floor without the library call that it costs on plain x86-64.
int FloorToInt(float value) {
  const int truncated = static_cast<int>(value);
  return truncated - (value < static_cast<float>(truncated) ? 1 : 0);
}

// A point's place in the order in which points are kept.
struct Place {
  int layer;
  uint64_t on_curve;
  uint32_t index;  // in the cloud
  int weight;

  bool operator<(const Place& other) const {
    return std::tie(layer, on_curve, index) < std::tie(other.layer, other.on_curve, other.index);
  }
};

// Of every step-th point.
int64_t TotalWeight(const std::vector<Place>& places, size_t step) {
  int64_t sum = 0;
  for (size_t i = 0; i < places.size(); i += step) sum += places[i].weight;
  return sum;
}

}  // namespace

MatchingScan::MatchingScan(const sensor::LabeledPointCloud& cloud, const ScoreModel& model,
                           size_t max_points) {
  std::vector<Place> places;
  places.reserve(cloud.size());
  float max_squared_range = 0.f;
  const float max_range = static_cast<float>(model.max_range_m());
  for (size_t i = 0; i < cloud.size(); ++i) {
    const int layer = model.LayerOf(cloud.labels[i]);
    const Eigen::Vector2f position = cloud.positions[i].head<2>();
    const float squared_range = position.squaredNorm();
    // Written so that what is not a number is out of range, too.
    const bool in_range = squared_range <= max_range * max_range;
    if (layer == ScoreModel::kNotMatched || !in_range || !cloud.positions[i].allFinite()) continue;
    max_squared_range = std::max(max_squared_range, squared_range);
    places.push_back(
        {layer, PlaceOnCurve(position), static_cast<uint32_t>(i), model.WeightOf(cloud.labels[i])});
  }
  std::sort(places.begin(), places.end());
  size_t step = 1;
  while ((places.size() + step - 1) / step > max_points ||
         TotalWeight(places, step) > kMaxTotalWeight)
    ++step;
  for (size_t i = 0; i < places.size(); i += step) {
    const Place& place = places[i];
    if (layers_.empty() || layers_.back().layer != place.layer) {
      layers_.push_back({place.layer, size(), size()});
    }
    x_.push_back(cloud.positions[place.index].x());
    y_.push_back(cloud.positions[place.index].y());
    weights_.push_back(place.weight);
    layers_.back().end = size();
  }
  total_weight_ = TotalWeight(places, step);
  radius_m_ = std::sqrt(static_cast<double>(max_squared_range));
}

ScanCells MatchingScan::CellsAt(const PlanarPose& grid_from_node, double resolution_m) const {
  const double scale = 1. / resolution_m;
  const auto cosine = static_cast<float>(std::cos(grid_from_node.yaw_rad) * scale);
  const auto sine = static_cast<float>(std::sin(grid_from_node.yaw_rad) * scale);
  // Whole cells are added as integers: far from the grid's origin, single precision would blur
  // them.
  const Eigen::Array2d offset = grid_from_node.translation.array() * scale;
  const Eigen::Array2i whole = offset.floor().cast<int>();
  const Eigen::Array2f part = (offset - whole.cast<double>()).cast<float>();
  // A loop of its own, for the compiler to do several points at a time.
  std::vector<int> cells_x(size()), cells_y(size());
  for (size_t i = 0; i < x_.size(); ++i) {
    cells_x[i] = whole.x() + FloorToInt(cosine * x_[i] - sine * y_[i] + part.x());
    cells_y[i] = whole.y() + FloorToInt(sine * x_[i] + cosine * y_[i] + part.y());
  }
  ScanCells result;
  result.cells.resize(size());
  ScanCell* const cells = result.cells.data();
  size_t num_cells = 0;
  for (const Layer& layer : layers_) {
    const size_t begin = num_cells;
    ScanCell last{std::numeric_limits<int>::min(), 0, 0};
    for (size_t i = layer.begin; i < layer.end; ++i) {
      // Without a branch: whether neighbours share a cell is anyone's guess.
      const bool same = (cells_x[i] == last.x) & (cells_y[i] == last.y) &
                        (last.weight + weights_[i] <= kMaxCellWeight);
      last = {cells_x[i], cells_y[i], weights_[i] + (same ? last.weight : 0)};
      num_cells += same ? 0 : 1;
      cells[num_cells - 1] = last;
    }
    result.layers.push_back({layer.layer, begin, num_cells});
  }
  result.cells.resize(num_cells);
  return result;
}

}  // namespace cartographer::scan_matching
