// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/label_count.h"

#include <gtest/gtest.h>

#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::SmallMap;

TEST(LabelCountTest, AnEmptyMapHasNothing) {
  ASSERT_EQ(CountMap(Map()).size(), 1u);  // kUnlabeled
  EXPECT_TRUE(CountMap(Map())[0].IsZero());
}

TEST(LabelCountTest, CountsHitsAndPointsApart) {
  Map map = SmallMap(1, 0);
  auto submap = std::make_shared<submap::Submap>(1.);
  submap->grid.AddHits(sensor::Label{2}, {0, 0}, 5);
  submap->grid.AddHits(sensor::Label{2}, {100, -100}, 7);
  submap->grid.AddHits(sensor::Label{3}, {0, 0}, 1);
  submap->cloud.positions.resize(2);
  submap->cloud.labels = {sensor::Label{3}, sensor::Label{3}};
  submap->cloud.certainties.resize(2);
  map.submaps[{1, 0}].submap = submap;
  auto cloud = std::make_shared<sensor::LabeledPointCloud>();
  cloud->positions.resize(1);
  cloud->labels = {sensor::Label{2}};
  cloud->certainties.resize(1);
  map.nodes.begin()->second.cloud = cloud;

  const LabelCounts counts = CountMap(map);
  ASSERT_EQ(counts.size(), map.labels.size());
  EXPECT_TRUE(counts[0].IsZero());
  EXPECT_EQ(counts[2].hits, 12u);
  EXPECT_EQ(counts[2].submap_points, 0u);
  EXPECT_EQ(counts[2].node_points, 1u);
  EXPECT_EQ(counts[3].hits, 1u);
  EXPECT_EQ(counts[3].submap_points, 2u);
}

TEST(LabelCountTest, DifferencesAreTakenOneByOne) {
  const LabelCounts difference = Difference({{5, 4, 3}, {1, 1, 1}}, {{2, 4, 0}, {1, 1, 1}});
  EXPECT_EQ(difference[0].hits, 3u);
  EXPECT_EQ(difference[0].submap_points, 0u);
  EXPECT_EQ(difference[0].node_points, 3u);
  EXPECT_TRUE(difference[1].IsZero());
}

TEST(LabelCountDeathTest, NothingMayHaveBecomeMore) {
  EXPECT_DEATH(Difference({{1, 0, 0}}, {{2, 0, 0}}), "label 0");
}

}  // namespace
}  // namespace cartographer::map
