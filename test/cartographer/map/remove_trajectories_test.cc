// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_trajectories.h"

#include <gtest/gtest.h>

#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::SmallMap;

TEST(RemoveTrajectoriesTest, NoneIsNone) {
  Map map = SmallMap(3, 2);
  const ElementCount gone = RemoveTrajectories({}, &map);
  EXPECT_EQ(gone.nodes + gone.submaps + gone.constraints, 0);
  EXPECT_EQ(map.nodes.size(), 6u);
}

TEST(RemoveTrajectoriesTest, TakesAllThatBelongsToIt) {
  for (const int removed : {1, 4}) {
    Map map = SmallMap(3, 2);
    const size_t constraints = map.constraints.size();
    const ElementCount gone = RemoveTrajectories({removed}, &map);
    EXPECT_EQ(gone.nodes, 3);
    EXPECT_EQ(gone.submaps, 2);
    EXPECT_EQ(gone.constraints, 4) << "3 within, 1 between the trajectories";
    EXPECT_EQ(map.constraints.size(), constraints - 4);
    for (const auto& [id, node] : map.nodes) EXPECT_NE(id.trajectory_id, removed);
    for (const auto& [id, submap] : map.submaps) EXPECT_NE(id.trajectory_id, removed);
    for (const Constraint& constraint : map.constraints) {
      EXPECT_EQ(map.nodes.count(constraint.node_id), 1u);
      EXPECT_EQ(map.submaps.count(constraint.submap_id), 1u);
    }
  }
}

}  // namespace
}  // namespace cartographer::map
