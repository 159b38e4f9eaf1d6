// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_shadow.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "cartographer/common/parallel.h"
#include "cartographer/io/ground_height.h"

namespace cartographer::io {
namespace {

// Shift of the shadow on the ground for a metre of height, along x and against y each [m].
constexpr double kShiftPerMetre = 0.25;
constexpr double kHighest_m = 8.;
// Points that lie closer than this to the ground may be part of it.
constexpr double kLowest_m = 0.15;
// The blur has to bridge the distance between a cloud's points [m]; two passes make it soft.
constexpr double kBlur_m = 0.2;
constexpr int kNumBlurs = 2;
// Densities of shadow points [1/m^2]: lone points below the first cast no shadow, so many more take
// 1 - 1/e of the light.
constexpr float kLoneDensity = 4.f;
constexpr float kDensity = 20.f;

using Counts = std::vector<std::atomic<uint32_t>>;

void AddShadow(const map::MapSubmap& placed, const sensor::LabelMask& without,
               const GroundHeight& ground, const RasterFrame& frame, Counts* counts) {
  const sensor::LabeledPointCloud& cloud = placed.submap->cloud;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (without.Contains(cloud.labels[i]) || !cloud.positions[i].allFinite()) continue;
    const Eigen::Vector3d position = placed.map_from_submap * cloud.positions[i].cast<double>();
    const double height =
        std::min(position.z() - ground.At(position.x(), position.y()), kHighest_m);
    if (!(height > kLowest_m)) continue;
    const double shift = kShiftPerMetre * height;
    const Eigen::Vector2d pixel = frame.PixelFromMap({position.x() + shift, position.y() - shift});
    if (!(pixel.x() >= 0. && pixel.x() < frame.width)) continue;
    if (!(pixel.y() >= 0. && pixel.y() < frame.height)) continue;
    (*counts)[static_cast<size_t>(pixel.y()) * frame.width + static_cast<size_t>(pixel.x())]
        .fetch_add(1, std::memory_order_relaxed);
  }
}

// Mean over 2 * radius + 1 values of a line, taken as 0 beyond its ends.
void BlurLine(const float* in, size_t stride, int length, int radius, float* out) {
  const float share = 1.f / (2 * radius + 1);
  float sum = 0.f;
  for (int i = 0; i < std::min(radius, length); ++i) sum += in[i * stride];
  for (int i = 0; i < length; ++i) {
    if (i + radius < length) sum += in[(i + radius) * stride];
    out[i * stride] = sum * share;
    if (i >= radius) sum -= in[(i - radius) * stride];
  }
}

void Blur(const RasterFrame& frame, int radius, std::vector<float>* image) {
  std::vector<float> rows(image->size());
  common::ParallelChunks(frame.height, 16, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      BlurLine(&(*image)[row * frame.width], 1, frame.width, radius, &rows[row * frame.width]);
    }
  });
  common::ParallelChunks(frame.width, 16, [&](size_t begin, size_t end) {
    for (size_t column = begin; column < end; ++column) {
      BlurLine(&rows[column], frame.width, frame.height, radius, &(*image)[column]);
    }
  });
}

}  // namespace

std::vector<float> CastShadows(const map::Map& map, const sensor::LabelMask& hidden,
                               const RasterFrame& frame) {
  std::vector<float> shadow(frame.size());
  const GroundHeight ground(map, frame);
  if (!ground.known()) return shadow;

  sensor::LabelMask without = hidden;
  without.Insert(sensor::kUnlabeled);
  for (size_t i = 0; i < map.labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    if (map.labels.HasRole(label, sensor::LabelRole::kGround)) without.Insert(label);
  }
  std::vector<const map::MapSubmap*> submaps;
  for (const auto& entry : map.submaps) submaps.push_back(&entry.second);
  Counts counts(frame.size());
  common::ParallelChunks(submaps.size(), 1, [&](size_t i, size_t) {
    AddShadow(*submaps[i], without, ground, frame, &counts);
  });
  for (size_t i = 0; i < shadow.size(); ++i) shadow[i] = counts[i];
  const int radius = static_cast<int>(std::ceil(kBlur_m / frame.resolution_m));
  for (int i = 0; radius > 0 && i < kNumBlurs; ++i) Blur(frame, radius, &shadow);
  const float density = static_cast<float>(1. / (frame.resolution_m * frame.resolution_m));
  for (float& value : shadow) {
    value = 1.f - std::exp(-std::max(0.f, density * value - kLoneDensity) / kDensity);
  }
  return shadow;
}

}  // namespace cartographer::io
