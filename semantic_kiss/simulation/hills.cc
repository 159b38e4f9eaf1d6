// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/hills.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cartographer/common/parallel.h"
#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kNode_m = 4.;
// Distance over which the field follows a recorded route's ups and downs.
constexpr double kFitRadius_m = 6.;

std::array<double, 3> SplineWeights(double t) {
  return {0.5 * (1. - t) * (1. - t), 0.75 - (t - 0.5) * (t - 0.5), 0.5 * t * t};
}

struct Sample {
  Eigen::Vector2d position;
  double height_m;
};

std::vector<Sample> SamplesOf(const Route& route, double mount_height_m) {
  std::vector<Sample> samples;
  for (size_t i = 0; i < route.poses.size(); ++i) {
    const Eigen::Vector2d& position = route.poses[i].position;
    if (!samples.empty() && (position - samples.back().position).norm() < 1.5) continue;
    samples.push_back({position, route.heights_m[i] - mount_height_m});
  }
  return samples;
}

}  // namespace

Hills::Hills(const Route& route, const Eigen::AlignedBox2d& bounds,
             const proto::WorldOptions& options, double mount_height_m, uint64_t seed)
    : origin_(bounds.min()) {
  columns_ = static_cast<int>(bounds.sizes().x() / kNode_m) + 3;
  rows_ = static_cast<int>(bounds.sizes().y() / kNode_m) + 3;
  heights_m_.resize(static_cast<size_t>(columns_) * rows_);
  if (!route.heights_m.empty()) {
    FitRoute(route, mount_height_m);
    return;
  }
  const uint64_t key = HashKey({seed, static_cast<uint64_t>(Purpose::kHills)});
  const double frequency = 1. / options.hill_length_m();
  for (size_t k = 0; k < heights_m_.size(); ++k) {
    const Eigen::Vector2d p =
        frequency * (origin_ + kNode_m * Eigen::Vector2d(k % columns_, k / columns_));
    heights_m_[k] = options.hill_height_m() * Roughness(key, p.x(), p.y());
  }
}

void Hills::FitRoute(const Route& route, double mount_height_m) {
  const std::vector<Sample> samples = SamplesOf(route, mount_height_m);
  cartographer::common::ParallelChunks(heights_m_.size(), 1024, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const Eigen::Vector2d node =
          origin_ + kNode_m * Eigen::Vector2d(k % columns_ - 0.5, k / columns_ - 0.5);
      double sum = 0., weights = 0.;
      for (const Sample& sample : samples) {
        const double distance2 = (sample.position - node).squaredNorm();
        const double spread = distance2 + kFitRadius_m * kFitRadius_m;
        const double weight = 1. / (spread * spread);
        sum += weight * sample.height_m;
        weights += weight;
      }
      heights_m_[k] = sum / weights;
    }
  });
}

double Hills::Height(const Eigen::Vector2d& position) const {
  const double x = std::clamp((position.x() - origin_.x()) / kNode_m, 0., columns_ - 3.);
  const double y = std::clamp((position.y() - origin_.y()) / kNode_m, 0., rows_ - 3.);
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const std::array<double, 3> u = SplineWeights(x - i);
  const std::array<double, 3> v = SplineWeights(y - j);
  double height_m = 0.;
  for (int row = 0; row < 3; ++row) {
    const double* h = &heights_m_[static_cast<size_t>(j + row) * columns_ + i];
    height_m += v[row] * (u[0] * h[0] + u[1] * h[1] + u[2] * h[2]);
  }
  return height_m;
}

}  // namespace semantic_kiss::simulation
