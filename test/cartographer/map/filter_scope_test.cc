// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/filter_scope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::SmallMap;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(FilterScopeTest, AllTrajectoriesUnlessSomeAreNamed) {
  const Map map = SmallMap(1, 1);
  const auto scope = FilterScope::Create({}, map);
  ASSERT_TRUE(scope.ok()) << scope.status();
  EXPECT_THAT(scope->trajectories, ElementsAre(1, 4));
  EXPECT_TRUE(scope->all_trajectories);
  EXPECT_TRUE(scope->Contains(submap::NodeId{4, 7}));
  EXPECT_FALSE(scope->Contains(submap::SubmapId{0, 0}));
}

TEST(FilterScopeTest, NamedOrAllButNamed) {
  const Map map = SmallMap(1, 1);
  proto::FilterOptions options;
  options.add_trajectories(4);
  EXPECT_THAT(FilterScope::Create(options, map)->trajectories, ElementsAre(4));
  EXPECT_FALSE(FilterScope::Create(options, map)->all_trajectories);
  options.add_trajectories(1);
  EXPECT_TRUE(FilterScope::Create(options, map)->all_trajectories);
  options.Clear();
  options.add_keep_trajectories(4);
  EXPECT_THAT(FilterScope::Create(options, map)->trajectories, ElementsAre(1));
  options.add_keep_trajectories(1);
  EXPECT_THAT(FilterScope::Create(options, map)->trajectories, IsEmpty());
}

TEST(FilterScopeTest, ErrorsTellWhatThereIs) {
  proto::FilterOptions options;
  options.add_trajectories(0);
  const auto error = [&](const Map& map) {
    return std::string(FilterScope::Create(options, map).status().message());
  };
  EXPECT_EQ(error(SmallMap(1, 1)), "trajectory: the map has no trajectory 0; it has 1, 4");
  EXPECT_EQ(error(Map()), "trajectory: the map has no trajectory 0; it has none");
  options.Clear();
  options.add_keep_trajectories(2);
  EXPECT_EQ(error(SmallMap(1, 1)), "keep_trajectory: the map has no trajectory 2; it has 1, 4");
  options.set_keep_trajectories(0, 1);
  options.add_trajectories(4);
  EXPECT_THAT(error(SmallMap(1, 1)), HasSubstr("give one of the two"));
}

}  // namespace
}  // namespace cartographer::map
