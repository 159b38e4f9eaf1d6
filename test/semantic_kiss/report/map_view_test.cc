// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/map_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/map_sketch.h"
#include "test/testing/small_map.h"

namespace semantic_kiss::report {
namespace {

using cartographer::map::Constraint;
using cartographer::map::Map;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::SmallMap;

TEST(MapViewTest, AnEmptyMapHasNoPaths) {
  const MapView view = ViewOf(EmptyMap(), {}, "caption");
  EXPECT_EQ(view.caption, "caption");
  EXPECT_TRUE(view.paths.empty());
  EXPECT_TRUE(view.colorings.empty());
  EXPECT_TRUE(view.closures.empty());
}

TEST(MapViewTest, EachTrajectoryIsAPath) {
  const MapView view = ViewOf(SmallMap(6, 5), {}, "");
  ASSERT_EQ(view.paths.size(), 2u);
  EXPECT_EQ(view.paths[0].name, "trajectory 1");
  EXPECT_EQ(view.paths[1].name, "trajectory 4");
  EXPECT_EQ(view.paths[0].positions.size(), 6u);
  ASSERT_EQ(view.colorings.size(), 2u);
  for (const Coloring& coloring : view.colorings) EXPECT_EQ(coloring.values.size(), 6u);
}

TEST(MapViewTest, ClosuresAreMarkedWhereBothEndsExist) {
  Map map = SmallMap(6, 5);
  map.constraints.clear();
  const auto& [node_id, node] = *map.nodes.rbegin();
  const auto& [submap_id, submap] = *map.submaps.begin();
  Constraint constraint;
  constraint.node_id = node_id;
  constraint.submap_id = submap_id;
  map.constraints.push_back(constraint);  // within the submap: no closure
  constraint.kind = Constraint::Kind::kInterSubmap;
  map.constraints.push_back(constraint);
  constraint.node_id.node_index = 12345;  // gone
  map.constraints.push_back(constraint);
  const MapView view = ViewOf(map, {}, "");
  ASSERT_EQ(view.closures.size(), 1u);
  EXPECT_EQ(view.closures[0].node, node.map_from_node.translation().head<2>());
  EXPECT_EQ(view.closures[0].submap, submap.map_from_submap.translation().head<2>());
  EXPECT_EQ(view.closures[0].facts.size(), view.closure_facts.size());
}

}  // namespace
}  // namespace semantic_kiss::report
