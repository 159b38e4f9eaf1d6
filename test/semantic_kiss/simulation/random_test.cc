// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace semantic_kiss::simulation {
namespace {

TEST(RandomTest, KeysAreOrderedAndDistinct) {
  EXPECT_EQ(HashKey({1, 2, 3}), HashKey({1, 2, 3}));
  EXPECT_NE(HashKey({1, 2, 3}), HashKey({1, 3, 2}));
  EXPECT_NE(HashKey({1, 2}), HashKey({1, 2, 0}));
  std::set<uint64_t> hashes;
  for (uint64_t a = 0; a < 100; ++a) {
    for (uint64_t b = 0; b < 100; ++b) hashes.insert(HashKey({a, b}));
  }
  EXPECT_EQ(hashes.size(), 10000u);
}

TEST(RandomTest, UniformAndNormalHaveTheirMoments) {
  Random random(7, Purpose::kRay);
  double sum = 0., sum_of_squares = 0., normal_sum = 0., normal_squares = 0.;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const double uniform = random.Uniform();
    ASSERT_GE(uniform, 0.);
    ASSERT_LT(uniform, 1.);
    sum += uniform;
    sum_of_squares += uniform * uniform;
    const double normal = random.Normal();
    normal_sum += normal;
    normal_squares += normal * normal;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.005);
  EXPECT_NEAR(sum_of_squares / kDraws, 1. / 3., 0.005);
  EXPECT_NEAR(normal_sum / kDraws, 0., 0.01);
  EXPECT_NEAR(normal_squares / kDraws, 1., 0.02);
}

TEST(RandomTest, NeighbouringKeysAreUncorrelated) {
  double sum = 0.;
  constexpr int kKeys = 100000;
  for (uint64_t key = 0; key < kKeys; ++key) {
    sum += (Random(3, Purpose::kRay, key).Uniform() - 0.5) *
           (Random(3, Purpose::kRay, key + 1).Uniform() - 0.5);
  }
  EXPECT_NEAR(12. * sum / kKeys, 0., 0.02);
}

TEST(RandomTest, NoiseIsSmoothBoundedAndZeroOnAverage) {
  double sum = 0., squares = 0.;
  int count = 0;
  for (double x = -20.; x < 20.; x += 0.173) {
    for (double y = -20.; y < 20.; y += 0.191) {
      const double noise = SmoothNoise(5, x, y);
      ASSERT_LE(std::abs(noise), 1.);
      ASSERT_NEAR(SmoothNoise(5, x + 1e-5, y), noise, 1e-4);
      ASSERT_NEAR(SmoothNoise(5, x, y - 1e-5), noise, 1e-4);
      sum += Roughness(5, x, y);
      squares += Roughness(5, x, y) * Roughness(5, x, y);
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0., 0.15);
  EXPECT_NEAR(std::sqrt(squares / count), 1., 0.15);
}

}  // namespace
}  // namespace semantic_kiss::simulation
