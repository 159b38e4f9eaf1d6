// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/probability_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace cartographer::submap {
namespace {

using Points = std::vector<Eigen::Vector2d>;

proto::ProbabilityGridOptions Options(bool cast_rays = true) {
  proto::ProbabilityGridOptions options;
  options.set_resolution_m(0.5);
  options.set_hit_probability(0.6);
  options.set_miss_probability(0.4);
  options.set_cast_rays(cast_rays);
  return options;
}

// P after odds of 3 : 2 have been multiplied `hits` times, or divided where negative.
double AfterHits(int hits) {
  const double odds = std::pow(1.5, hits);
  return odds / (1. + odds);
}

TEST(ProbabilityGridTest, KnowsNothingAtFirst) {
  const ProbabilityGrid grid(Options());
  EXPECT_TRUE(grid.bounds().Empty());
  EXPECT_FALSE(grid.IsKnown({0, 0}));
  EXPECT_FLOAT_EQ(grid.Probability({0, 0}), 0.1f);
  EXPECT_EQ(grid.EquivalentHits({0, 0}), 0);
}

TEST(ProbabilityGridTest, OddsMultiplyScanByScanUpToTheirBounds) {
  ProbabilityGrid grid(Options());
  const CellIndex free(1, 0), wall(4, 0);
  for (int scan = 1; scan <= 9; ++scan) {
    // However many points fall into a cell, it is one hit.
    grid.InsertScan({0.1, 0.2}, {{2.1, 0.3}, {2.2, 0.1}, {2.4, 0.2}});
    EXPECT_NEAR(grid.Probability(wall), std::min(AfterHits(scan), 0.9), 1e-3) << scan;
    EXPECT_NEAR(grid.Probability(free), std::max(AfterHits(-scan), 0.1), 1e-3) << scan;
    EXPECT_EQ(grid.EquivalentHits(wall), std::min(scan, 5));  // log(9) / log(1.5) = 5.4
    EXPECT_EQ(grid.EquivalentHits(free), 0);
  }
  EXPECT_FALSE(grid.IsKnown({5, 0}));
  EXPECT_FALSE(grid.IsKnown({1, 1}));
}

TEST(ProbabilityGridTest, InOneScanHitsOutdoRays) {
  ProbabilityGrid grid(Options());
  grid.InsertScan({0.25, 0.25}, {{2.25, 0.25}, {4.25, 0.25}});
  EXPECT_NEAR(grid.Probability({4, 0}), 0.6, 1e-3);
  EXPECT_NEAR(grid.Probability({6, 0}), 0.4, 1e-3);
  EXPECT_NEAR(grid.Probability({8, 0}), 0.6, 1e-3);
}

TEST(ProbabilityGridTest, WithoutRaysNothingBecomesFree) {
  ProbabilityGrid grid(Options(false));
  grid.InsertScan({0., 0.}, {{3., 4.}});
  EXPECT_TRUE(grid.IsKnown({6, 8}));
  EXPECT_FALSE(grid.IsKnown({3, 4}));
}

TEST(ProbabilityGridTest, GrowingChangesNothing) {
  ProbabilityGrid grid(Options());
  grid.InsertScan({0.1, 0.1}, {{3.3, 1.2}});
  std::vector<std::pair<CellIndex, float>> before;
  for (int y = -10; y < 10; ++y) {
    for (int x = -10; x < 10; ++x) before.push_back({{x, y}, grid.Probability({x, y})});
  }
  grid.InsertScan({-70., 50.}, {{-75., 50.}, {-70., -90.}});
  for (const auto& [cell, probability] : before) EXPECT_EQ(grid.Probability(cell), probability);
  EXPECT_TRUE(grid.IsKnown(grid.CellOf({-75., 50.})));
}

// Cells that a segment passes through, and how deep: by walking along it.
std::set<std::pair<int, int>> CellsAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                         const ProbabilityGrid& grid) {
  std::set<std::pair<int, int>> cells;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const CellIndex cell = grid.CellOf(from + (to - from) * i / kSteps);
    cells.emplace(cell.x(), cell.y());
  }
  return cells;
}

TEST(ProbabilityGridTest, ARayPassesThroughTheCellsOnItsWayAndNoOthers) {
  constexpr int kSeed = 5;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-15., 15.);
  for (int i = 0; i < 50; ++i) {
    ProbabilityGrid grid(Options());
    const Eigen::Vector2d origin(uniform(random), uniform(random));
    const CellIndex end = grid.CellOf({uniform(random), uniform(random)});
    const Eigen::Vector2d center = (end.cast<double>() + 0.5).matrix() * grid.resolution_m();
    grid.InsertScan(origin, {center});
    const auto expected = CellsAlong(origin, center, grid);
    int known = 0;
    for (int y = -35; y < 35; ++y) {
      for (int x = -35; x < 35; ++x) {
        if (!grid.IsKnown({x, y})) continue;
        ++known;
        EXPECT_EQ(grid.Probability({x, y}) > 0.5f, x == end.x() && y == end.y());
      }
    }
    int hit = 0;
    for (const auto& [x, y] : expected) hit += grid.IsKnown({x, y});
    // Steps may miss a cell whose corner is cut.
    EXPECT_EQ(hit, expected.size());
    EXPECT_LE(known - hit, 2);
  }
}

TEST(ProbabilityGridTest, TheLongestRayOfADirectionStandsForTheOthers) {
  constexpr int kSeed = 6;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-20., 20.);
  ProbabilityGrid grid(Options());
  Points points;
  for (int i = 0; i < 2000; ++i) points.emplace_back(uniform(random), uniform(random));
  const Eigen::Vector2d origin(0.2, -0.1);
  grid.InsertScan(origin, points);
  std::set<std::pair<int, int>> all;
  for (int i = 0; i < 2000; i += 20) {
    all.merge(CellsAlong(origin, points[i], grid));
  }
  int known = 0;
  for (const auto& [x, y] : all) known += grid.IsKnown({x, y});
  EXPECT_GT(known, 0.97 * all.size());
}

TEST(ProbabilityGridTest, RowsAreThatOfSingleCellsInsideAndOut) {
  ProbabilityGrid grid(Options());
  grid.InsertScan({0., 0.}, {{3., 2.}, {-2., 1.}});
  for (int y = -6; y < 8; ++y) {
    for (int x = -12; x < 10; ++x) {
      grid.ForRow({x, y}, 4, [&](int column, float probability) {
        EXPECT_EQ(probability, grid.Probability({x + column, y}));
      });
    }
  }
}

TEST(ProbabilityGridTest, CountsMoreScansThanAStampHolds) {
  ProbabilityGrid grid(Options());
  for (int scan = 0; scan < 70000; ++scan) grid.InsertScan({0.1, 0.1}, {{0.7, 0.1}});
  grid.InsertScan({0.1, 0.1}, {{1.2, 0.1}});
  EXPECT_LT(grid.Probability({1, 0}), 0.9);
  EXPECT_NEAR(grid.Probability({2, 0}), 0.6, 1e-3);
}

}  // namespace
}  // namespace cartographer::submap
