// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/cell_set.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace cartographer::map {
namespace {

TEST(CellSetTest, HoldsWhatWasInserted) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> uniform(-40, 40);
  CellSet set;
  EXPECT_TRUE(set.Empty());
  std::set<std::pair<int, int>> expected;
  for (int i = 0; i < 500; ++i) {
    const int x = uniform(random), y = uniform(random);
    set.Insert({x, y});
    expected.emplace(x, y);
  }
  EXPECT_FALSE(set.Empty());
  for (int y = -50; y <= 50; ++y) {
    for (int x = -50; x <= 50; ++x) {
      EXPECT_EQ(set.Contains({x, y}), expected.count({x, y}) > 0) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace cartographer::map
