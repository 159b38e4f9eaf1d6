// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/ground_height.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include "cartographer/common/parallel.h"
#include "cartographer/sensor/label.h"

namespace cartographer::io {
namespace {

constexpr double kSquareSide_m = 1.;

RasterFrame SquaresOf(const RasterFrame& frame) {
  RasterFrame squares = frame;
  squares.resolution_m = std::max(kSquareSide_m, frame.resolution_m);
  const double pixels = squares.resolution_m / frame.resolution_m;
  squares.width = static_cast<int>(std::ceil(frame.width / pixels));
  squares.height = static_cast<int>(std::ceil(frame.height / pixels));
  return squares;
}

// Heights in whole millimetres: integer sums come out the same in any order of addition.
struct Sum {
  std::atomic<int64_t> millimetres{0};
  std::atomic<int64_t> count{0};
};

void AddGround(const map::MapSubmap& placed, const sensor::LabelMask& ground,
               const RasterFrame& squares, std::vector<Sum>* sums) {
  const sensor::LabeledPointCloud& cloud = placed.submap->cloud;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!ground.Contains(cloud.labels[i]) || !cloud.positions[i].allFinite()) continue;
    const Eigen::Vector3d position = placed.map_from_submap * cloud.positions[i].cast<double>();
    const Eigen::Vector2d pixel = squares.PixelFromMap(position.head<2>());
    if (!(pixel.x() >= 0. && pixel.x() < squares.width)) continue;
    if (!(pixel.y() >= 0. && pixel.y() < squares.height)) continue;
    if (!(std::abs(position.z()) < 1e6)) continue;
    Sum& sum =
        (*sums)[static_cast<size_t>(pixel.y()) * squares.width + static_cast<size_t>(pixel.x())];
    sum.millimetres.fetch_add(std::llround(position.z() * 1e3), std::memory_order_relaxed);
    sum.count.fetch_add(1, std::memory_order_relaxed);
  }
}

}  // namespace

GroundHeight::GroundHeight(const map::Map& map, const RasterFrame& frame)
    : frame_(SquaresOf(frame)) {
  std::vector<const map::MapSubmap*> submaps;
  for (const auto& entry : map.submaps) submaps.push_back(&entry.second);
  const sensor::LabelMask& ground = map.labels.WithRole(sensor::LabelRole::kGround);
  std::vector<Sum> sums(frame_.size());
  common::ParallelChunks(submaps.size(), 1,
                         [&](size_t i, size_t) { AddGround(*submaps[i], ground, frame_, &sums); });
  Level finest{frame_.width, frame_.height, std::vector<float>(frame_.size()),
               std::vector<float>(frame_.size())};
  for (size_t i = 0; i < sums.size(); ++i) {
    const int64_t count = sums[i].count;
    if (count == 0) continue;
    known_ = true;
    finest.heights[i] = static_cast<float>(1e-3 * sums[i].millimetres / count);
    finest.weights[i] = 1.f;
  }
  if (known_) {
    Fill(std::move(finest));
  } else {
    heights_ = std::move(finest.heights);
  }
}

GroundHeight::Level GroundHeight::Halve(const Level& fine) {
  Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
  coarse.heights.resize(static_cast<size_t>(coarse.width) * coarse.height);
  coarse.weights.resize(coarse.heights.size());
  for (int row = 0; row < fine.height; ++row) {
    for (int column = 0; column < fine.width; ++column) {
      const size_t from = static_cast<size_t>(row) * fine.width + column;
      const size_t to = static_cast<size_t>(row / 2) * coarse.width + column / 2;
      coarse.heights[to] += fine.weights[from] * fine.heights[from];
      coarse.weights[to] += fine.weights[from];
    }
  }
  for (size_t i = 0; i < coarse.heights.size(); ++i) {
    if (coarse.weights[i] > 0.f) coarse.heights[i] /= coarse.weights[i];
  }
  return coarse;
}

void GroundHeight::FillFrom(const Level& coarse, Level* fine) {
  for (int row = 0; row < fine->height; ++row) {
    for (int column = 0; column < fine->width; ++column) {
      const size_t to = static_cast<size_t>(row) * fine->width + column;
      if (fine->weights[to] > 0.f) continue;
      fine->heights[to] = coarse.heights[static_cast<size_t>(row / 2) * coarse.width + column / 2];
    }
  }
}

void GroundHeight::Fill(Level finest) {
  std::vector<Level> levels{std::move(finest)};
  while (levels.back().heights.size() > 1) levels.push_back(Halve(levels.back()));
  for (size_t i = levels.size() - 1; i > 0; --i) FillFrom(levels[i], &levels[i - 1]);
  heights_ = std::move(levels.front().heights);
}

float GroundHeight::At(double x, double y) const {
  const Eigen::Vector2d pixel = frame_.PixelFromMap({x, y});
  const int column = static_cast<int>(std::clamp(pixel.x(), 0., frame_.width - 1.));
  const int row = static_cast<int>(std::clamp(pixel.y(), 0., frame_.height - 1.));
  return heights_[static_cast<size_t>(row) * frame_.width + column];
}

}  // namespace cartographer::io
