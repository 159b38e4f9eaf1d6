// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/nearest_name.h"

#include <gtest/gtest.h>

namespace cartographer::common {
namespace {

TEST(EditDistanceTest, HandlesEmptyEqualAndDisjointWords) {
  EXPECT_EQ(EditDistance("", ""), 0);
  EXPECT_EQ(EditDistance("", "car"), 3);
  EXPECT_EQ(EditDistance("car", ""), 3);
  EXPECT_EQ(EditDistance("car", "car"), 0);
  EXPECT_EQ(EditDistance("car", "dog"), 3);
}

TEST(EditDistanceTest, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(EditDistance("datset", "dataset"), 1);
  EXPECT_EQ(EditDistance("dataset", "datset"), 1);
  EXPECT_EQ(EditDistance("trunk", "truck"), 1);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
}

TEST(NearestNameTest, PicksTheNearestAndTheFirstOfEquals) {
  EXPECT_EQ(NearestName("max_rang", {"min_range", "max_range"}), "max_range");
  EXPECT_EQ(NearestName("c", {"a", "b"}), "a");
  EXPECT_EQ(NearestName("anything", {}), "");
}

}  // namespace
}  // namespace cartographer::common
