// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/free_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace cartographer::map {
namespace {

proto::TransientOptions Options(int min_ground_hits, double max_movable_share) {
  proto::TransientOptions options;
  options.set_min_ground_hits(min_ground_hits);
  options.set_max_movable_share(max_movable_share);
  return options;
}

TEST(FreeCellsTest, NothingSeenIsNotFree) {
  const VisitedSquare square({0, 0}, 4, 1);
  for (const bool free : square.FreeCells(Options(1, 1.))) EXPECT_FALSE(free);
}

TEST(FreeCellsTest, GroundIsFreeUnlessSomethingStandsNearby) {
  VisitedSquare square({10, 20}, 5, 0);
  square.AddGround({12, 20}, 3);
  square.AddGround({13, 21}, 3);
  square.AddStanding({13, 21}, 1);
  square.AddGround({14, 22}, 2);
  const std::vector<bool> free = square.FreeCells(Options(3, 0.3));
  EXPECT_TRUE(free[2]);
  EXPECT_FALSE(free[1 * 5 + 3]);  // 1 > 0.3 * 3
  EXPECT_FALSE(free[2 * 5 + 4]);  // too few hits
  EXPECT_TRUE(square.FreeCells(Options(3, 0.34))[1 * 5 + 3]);
}

// Against sums taken one by one, at a square that spans the origin.
TEST(FreeCellsTest, AgreesWithCountingOneByOne) {
  constexpr int kSide = 9;
  for (const int reach : {0, 1, 3, 12}) {
    std::mt19937 random(reach + 1);
    std::uniform_int_distribution<int> place(-30, 30), hits(1, 6);
    const submap::CellIndex min(-4, -7);
    VisitedSquare square(min, kSide, reach);
    std::map<std::pair<int, int>, int> ground, standing;
    for (int i = 0; i < 1500; ++i) {
      const int x = place(random), y = place(random), h = hits(random);
      if (i % 11 == 0) {
        square.AddStanding({x, y}, h);
        standing[{x, y}] += h;
      } else {
        square.AddGround({x, y}, h);
        ground[{x, y}] += h;
      }
    }
    const std::vector<bool> free = square.FreeCells(Options(2, 0.1));
    ASSERT_EQ(free.size(), size_t{kSide * kSide});
    int num_free = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        int ground_hits = 0, standing_hits = 0;
        for (int dy = -reach; dy <= reach; ++dy) {
          for (int dx = -reach; dx <= reach; ++dx) {
            const std::pair<int, int> near(min.x() + x + dx, min.y() + y + dy);
            if (ground.count(near) > 0) ground_hits += ground.at(near);
            if (standing.count(near) > 0) standing_hits += standing.at(near);
          }
        }
        const bool expected = ground_hits >= 2 && standing_hits <= 0.1 * ground_hits;
        EXPECT_EQ(free[y * kSide + x], expected) << reach << ": " << x << " " << y;
        num_free += expected;
      }
    }
    if (reach > 3) continue;  // the more is summed up, the less do cells differ
    EXPECT_GT(num_free, 0) << reach;
    EXPECT_LT(num_free, kSide * kSide) << reach;
  }
}

}  // namespace
}  // namespace cartographer::map
