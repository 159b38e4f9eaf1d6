// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/probability_surface.h"

#include <gtest/gtest.h>

#include <random>

#include "test/cartographer/scan_matching/room_scene.h"

namespace cartographer::scan_matching {
namespace {

TEST(ProbabilitySurfaceTest, HasTheCellsValuesAtTheirCentres) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const ProbabilitySurface surface(grid);
  for (int y = 35; y < 65; ++y) {
    for (int x = 0; x < 50; ++x) {
      EXPECT_NEAR(surface.At({0.1 * (x + 0.5), 0.1 * (y + 0.5)}).value, grid.Probability({x, y}),
                  1e-6);
    }
  }
}

TEST(ProbabilitySurfaceTest, IsFlatWhereNothingIsKnown) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const auto sample = ProbabilitySurface(grid).At({100., -50.});
  EXPECT_NEAR(sample.value, submap::ProbabilityGrid::kMinProbability, 1e-6);
  EXPECT_NEAR(sample.gradient.norm(), 0., 1e-6);
}

TEST(ProbabilitySurfaceTest, GradientsEqualNumericOnes) {
  constexpr int kSeed = 7;
  constexpr double kStep = 1e-6;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const ProbabilitySurface surface(grid);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d place(10. + 0.5 * uniform(random), 5. * uniform(random));
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      const double slope =
          (surface.At(place + step).value - surface.At(place - step).value) / (2. * kStep);
      EXPECT_NEAR(surface.At(place).gradient[axis], slope, 1e-4);
    }
  }
}

}  // namespace
}  // namespace cartographer::scan_matching
