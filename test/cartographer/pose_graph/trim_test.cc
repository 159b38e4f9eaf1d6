// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/trim.h"

#include <gtest/gtest.h>

#include "test/cartographer/pose_graph/small_drive.h"

namespace cartographer::pose_graph {
namespace {

Graph TwoDrives() {
  Graph graph;
  AddDrive(0, OutAndBack(20, 4.), 10, &graph);
  AddDrive(1, OutAndBack(20, 4.), 10, &graph);
  graph.constraints.push_back(
      ClosureBetween({0, 0}, {1, 5}, graph.nodes.at({1, 5}).map_from_node, graph));
  return graph;
}

TEST(TrimTest, OnlyWhatLiesBeforeGoes) {
  Graph graph = TwoDrives();
  TrimBefore({1, 15}, &graph);
  EXPECT_EQ(graph.nodes.size(), 42u + 27u);
  EXPECT_EQ(graph.nodes.count({1, 14}), 0u);
  EXPECT_EQ(graph.nodes.count({1, 15}), 1u);
  EXPECT_EQ(graph.submaps.count({1, 0}), 0u);
  EXPECT_EQ(graph.submaps.count({1, 1}), 1u);  // node 15 is in it
  for (const auto& constraint : graph.constraints) {
    EXPECT_EQ(graph.nodes.count(constraint.node_id), 1u);
    EXPECT_EQ(graph.submaps.count(constraint.submap_id), 1u);
    EXPECT_EQ(constraint.kind, submap::Constraint::Kind::kIntraSubmap);  // node 5 is gone
  }
}

TEST(TrimTest, SubmapsThatGrowStay) {
  Graph graph = TwoDrives();
  auto growing = std::make_shared<submap::Submap>(0.2);
  graph.submaps.at({1, 0}).submap = growing;
  TrimBefore({1, 15}, &graph);
  EXPECT_EQ(graph.submaps.count({1, 0}), 1u);
}

TEST(TrimTest, ATrajectoryGoesAsAWhole) {
  Graph graph = TwoDrives();
  RemoveTrajectory(1, &graph);
  Graph alone;
  AddDrive(0, OutAndBack(20, 4.), 10, &alone);
  EXPECT_EQ(graph.nodes.size(), alone.nodes.size());
  EXPECT_EQ(graph.submaps.size(), alone.submaps.size());
  EXPECT_EQ(graph.constraints.size(), alone.constraints.size());
}

}  // namespace
}  // namespace cartographer::pose_graph
