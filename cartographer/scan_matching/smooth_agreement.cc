// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/smooth_agreement.h"

#include <cmath>
#include <cstdint>

#include "cartographer/scan_matching/score_model.h"

namespace cartographer::scan_matching {
namespace {

// The four cubic B-splines that are not zero at a place `t` in [0, 1) between the second and the
// third of their cells, and their derivatives.
struct Splines {
  explicit Splines(double t) {
    const double u = 1. - t, t2 = t * t, u2 = u * u;
    value << u2 * u, 4. - 3. * t2 * (1. + u), 4. - 3. * u2 * (1. + t), t2 * t;
    value /= 6.;
    slope << -0.5 * u2, t * (1.5 * t - 2.), u * (2. - 1.5 * u), 0.5 * t2;
  }
  Eigen::Vector4d value, slope;
};

}  // namespace

SmoothAgreement::Sample SmoothAgreement::At(int layer, const Eigen::Vector2d& position) const {
  // In cells, counted from their centres.
  const Eigen::Array2d place = position.array() / resolution_m_ - 0.5;
  const Eigen::Array2d base = place.floor();
  const PyramidLevel& level = pyramid_.level(0);
  const PyramidLevel::Window window = level.WindowOf(pyramid_.PlaneOf(0, layer));
  // Columns wrap around to large numbers below the window, where squares of bytes touch nothing.
  const auto column = static_cast<uint32_t>(static_cast<int>(base.x()) - 1 - window.first_column);
  const auto row = static_cast<uint32_t>(static_cast<int>(base.y()) - 1 - window.first_row);
  if (column >= window.num_columns || row >= window.num_rows) {
    return {0., Eigen::Vector2d::Zero()};
  }
  const Splines x(place.x() - base.x()), y(place.y() - base.y());
  const uint8_t* bytes = level.bytes() + window.begin + size_t{row} * level.stride() + column;
  Sample sample{0., Eigen::Vector2d::Zero()};
  for (int i = 0; i < 4; ++i, bytes += level.stride()) {
    const Eigen::Vector4d cells(bytes[0], bytes[1], bytes[2], bytes[3]);
    const double along_row = cells.dot(x.value);
    sample.value += y.value[i] * along_row;
    sample.gradient.x() += y.value[i] * cells.dot(x.slope);
    sample.gradient.y() += y.slope[i] * along_row;
  }
  sample.value /= ScoreModel::kFullAgreement;
  sample.gradient /= ScoreModel::kFullAgreement * resolution_m_;
  return sample;
}

}  // namespace cartographer::scan_matching
