// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/voxel_index.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace cartographer::registration {
namespace {

TEST(VoxelIndexTest, BehavesLikeAMapUnderRandomUse) {
  constexpr int kSeed = 17;
  std::mt19937 random(kSeed);
  // Few distinct keys, so that runs of probes are long and erasing from their middle is common.
  std::uniform_int_distribution<int> coordinate(-4, 4);
  std::map<VoxelKey, uint32_t> expected;
  VoxelIndex index;
  for (uint32_t step = 0; step < 200000; ++step) {
    const VoxelKey key = KeyOf({coordinate(random), coordinate(random), coordinate(random)});
    const auto it = expected.find(key);
    ASSERT_EQ(index.Find(key), it == expected.end() ? VoxelIndex::kNone : it->second) << step;
    if (it == expected.end()) {
      ASSERT_EQ(index.FindOrInsert(key, step), VoxelIndex::kNone);
      expected[key] = step;
    } else if (step % 3 == 0) {
      index.Assign(key, step);
      it->second = step;
    } else {
      index.Erase(key);
      expected.erase(it);
    }
    ASSERT_EQ(index.size(), expected.size());
  }
}

TEST(VoxelIndexTest, GrowsAndClears) {
  VoxelIndex index;
  for (int i = 0; i < 100000; ++i) {
    ASSERT_EQ(index.FindOrInsert(KeyOf({i, -i, 2 * i}), i), VoxelIndex::kNone);
  }
  for (int i = 0; i < 100000; ++i) ASSERT_EQ(index.Find(KeyOf({i, -i, 2 * i})), i);
  index.Clear();
  EXPECT_EQ(index.size(), 0);
  EXPECT_EQ(index.Find(KeyOf({5, -5, 10})), VoxelIndex::kNone);
}

TEST(VoxelTest, VoxelsTileSpaceAcrossZero) {
  EXPECT_TRUE((VoxelOf({-0.1, 0.1, -1.0}, 1.) == VoxelCoordinates(-1, 0, -1)).all());
  EXPECT_TRUE((VoxelOf({-2.5, 2.5, 0.}, 2.) == VoxelCoordinates(-5, 5, 0)).all());
  EXPECT_NE(KeyOf({-1, 0, 0}), KeyOf({0, -1, 0}));
  EXPECT_NE(KeyOf({-1, 0, 0}), KeyOf({0, 0, 0}));
}

}  // namespace
}  // namespace cartographer::registration
