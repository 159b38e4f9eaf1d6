// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/random.h"

#include <cmath>

#include "semantic_kiss/simulation/floor.h"

namespace semantic_kiss::simulation {
namespace {

double LatticeValue(uint64_t key, int64_t x, int64_t y) {
  const uint64_t cell =
      static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15 ^ static_cast<uint64_t>(y) * 0xc2b2ae3d27d4eb4f;
  return 2. * ToUniform(Scramble(Scramble(key + cell) ^ cell)) - 1.;
}

double Fade(double t) { return t * t * (3. - 2. * t); }

}  // namespace

double Random::Normal() {
  const double radius = std::sqrt(-2. * std::log(1. - Uniform()));
  return radius * std::cos(2. * M_PI * Uniform());
}

double Random::QuickNormal() {
  // The eight bytes of a hash, added up two by two, then all.
  const uint64_t hash = Next();
  constexpr uint64_t kEveryOther = 0x00ff00ff00ff00ff;
  const uint64_t pairs = (hash & kEveryOther) + ((hash >> 8) & kEveryOther);
  const uint64_t sum = (pairs * 0x0001000100010001) >> 48;
  constexpr double kMean = 8. * 127.5;
  constexpr double kPerDeviation = 1. / 209.022;  // sqrt(8 * (256^2 - 1) / 12)
  return (static_cast<double>(sum) - kMean) * kPerDeviation;
}

double SmoothNoise(uint64_t key, double x, double y) {
  const int64_t i = Floor(x);
  const int64_t j = Floor(y);
  const double u = Fade(x - static_cast<double>(i));
  const double v = Fade(y - static_cast<double>(j));
  const double low = LatticeValue(key, i, j) * (1. - u) + LatticeValue(key, i + 1, j) * u;
  const double high = LatticeValue(key, i, j + 1) * (1. - u) + LatticeValue(key, i + 1, j + 1) * u;
  return low * (1. - v) + high * v;
}

double Roughness(uint64_t key, double x, double y) {
  constexpr double kScale = 2.2;  // makes the standard deviation of the sum 1
  return kScale * (SmoothNoise(key, x, y) + 0.5 * SmoothNoise(key + 1, 2.17 * x, 2.17 * y));
}

}  // namespace semantic_kiss::simulation
