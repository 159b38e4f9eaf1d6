// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/matcher_cache.h"

#include <gtest/gtest.h>

#include "cartographer/common/parallel.h"
#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::scan_matching {
namespace {

submap::Submap SubmapWithPoles(int num_poles) {
  submap::Submap submap(0.5);
  for (int i = 0; i < num_poles; ++i) submap.grid.AddHits(LabelAt(6), {3 * i, i % 5}, 5);
  submap.finished = true;
  return submap;
}

ScoreModel Model() { return SmallModel(SmallOptions("dominant_label")); }

TEST(MatcherCacheTest, BuildsEachMatcherOnceWithinTheBudget) {
  MatcherCache cache(Model(), 1 << 30);
  const submap::Submap submap = SubmapWithPoles(10);
  const auto first = cache.Get({0, 1}, submap);
  EXPECT_EQ(cache.Get({0, 1}, submap), first);
  EXPECT_EQ(cache.num_built(), 1);
  EXPECT_EQ(cache.num_bytes(), first->num_bytes());
  EXPECT_GT(first->num_bytes(), 30u * 5u);
  EXPECT_NE(cache.Get({1, 1}, submap), first);
  EXPECT_EQ(cache.num_bytes(), 2 * first->num_bytes());
}

TEST(MatcherCacheTest, DropsWhatWasNotAskedForLongest) {
  const submap::Submap submap = SubmapWithPoles(10);
  const size_t size = SubmapMatcher(submap.grid, Model()).num_bytes();
  MatcherCache cache(Model(), 2 * size);
  const auto first = cache.Get({0, 0}, submap);
  cache.Get({0, 1}, submap);
  cache.Get({0, 0}, submap);
  cache.Get({0, 2}, submap);  // drops 1, not 0
  EXPECT_EQ(cache.num_matchers(), 2);
  EXPECT_EQ(cache.num_bytes(), 2 * size);
  EXPECT_EQ(cache.Get({0, 0}, submap), first);
  EXPECT_EQ(cache.num_built(), 3);
  cache.Get({0, 1}, submap);
  EXPECT_EQ(cache.num_built(), 4);
}

TEST(MatcherCacheTest, MatchersLiveOnWithThoseWhoHoldThem) {
  MatcherCache cache(Model(), 0);
  const submap::Submap submap = SubmapWithPoles(10);
  const auto matcher = cache.Get({0, 0}, submap);
  EXPECT_EQ(cache.num_matchers(), 0);
  EXPECT_EQ(cache.num_bytes(), 0);
  sensor::LabeledPointCloud cloud;
  AddPoint(1.6, 0.6, 6, &cloud);
  EXPECT_EQ(matcher->ScoreAt(MatchingScan(cloud, Model()), {}), 1.);
}

TEST(MatcherCacheTest, ForgetsWhatIsRemoved) {
  MatcherCache cache(Model(), 1 << 30);
  const submap::Submap submap = SubmapWithPoles(10);
  cache.Get({0, 0}, submap);
  cache.Remove({0, 0});
  cache.Remove({7, 7});
  EXPECT_EQ(cache.num_bytes(), 0);
  cache.Get({0, 0}, submap);
  EXPECT_EQ(cache.num_built(), 2);
}

TEST(MatcherCacheTest, ServesManyThreads) {
  const submap::Submap submap = SubmapWithPoles(40);
  const size_t size = SubmapMatcher(submap.grid, Model()).num_bytes();
  MatcherCache cache(Model(), 3 * size);
  common::ParallelChunks(200, 1, [&](size_t i, size_t) {
    EXPECT_EQ(cache.Get({0, static_cast<int>(i % 7)}, submap)->num_bytes(), size);
  });
  EXPECT_LE(cache.num_bytes(), 3 * size);
  EXPECT_EQ(cache.num_bytes(), cache.num_matchers() * size);
}

TEST(MatcherCacheDeathTest, GrowingSubmapsAreABug) {
  MatcherCache cache(Model(), 1 << 30);
  EXPECT_DEATH(cache.Get({2, 5}, submap::Submap(0.5)), "submap 2, 5");
}

}  // namespace
}  // namespace cartographer::scan_matching
