// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/topology.h"

#include <gtest/gtest.h>

#include "test/cartographer/pose_graph/small_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using submap::SubmapId;

TEST(TopologyTest, MeasuresTheWayAlongTheTrajectory) {
  Graph graph;
  AddDrive(0, OutAndBack(50, 4.), 10, &graph);
  const Topology topology(graph);
  EXPECT_EQ(topology.DrivenTo({0, 0}), 0.);
  EXPECT_DOUBLE_EQ(topology.DrivenTo({0, 50}), 50.);
  EXPECT_DOUBLE_EQ(topology.DrivenTo({0, 51}), 54.);  // the step to the other lane
  EXPECT_DEATH(topology.DrivenTo({3, 0}), "3, 0");
}

TEST(TopologyTest, KnowsWhoIsInASubmap) {
  Graph graph;
  AddDrive(2, OutAndBack(50, 4.), 10, &graph);
  graph.submaps[{2, 99}] = graph.submaps.begin()->second;
  const Topology topology(graph);
  EXPECT_TRUE(*topology.MiddleNode({2, 1}) == (NodeId{2, 15}));
  EXPECT_EQ(topology.MiddleNode({2, 99}), nullptr);
  EXPECT_TRUE(*topology.OldestSubmapOf({2, 19}) == (SubmapId{2, 1}));
  EXPECT_EQ(topology.OldestSubmapOf({2, 1000}), nullptr);
}

TEST(TopologyTest, ClosuresShortenPaths) {
  Graph graph;
  AddDrive(0, OutAndBack(100, 4.), 10, &graph);
  // Node 190 comes back by node 15, the middle of submap 1.
  const double far = Topology(graph).PathsFrom({0, 190}).at({0, 1});
  EXPECT_DOUBLE_EQ(far, 190. - 15. - 1. + 4.);
  graph.constraints.push_back(
      ClosureBetween({0, 1}, {0, 180}, graph.nodes.at({0, 180}).map_from_node, graph));
  const auto paths = Topology(graph).PathsFrom({0, 190});
  EXPECT_DOUBLE_EQ(paths.at({0, 1}), 10.);
  EXPECT_DOUBLE_EQ(paths.at({0, 2}), 20.);  // one submap on from there
}

TEST(TopologyTest, WhatNothingTiesIsNotReached) {
  Graph graph;
  AddDrive(0, OutAndBack(20, 4.), 10, &graph);
  AddDrive(1, OutAndBack(20, 4.), 10, &graph);
  EXPECT_EQ(Topology(graph).PathsFrom({1, 0}).count({0, 0}), 0u);
  graph.constraints.push_back(
      ClosureBetween({0, 0}, {1, 5}, graph.nodes.at({1, 5}).map_from_node, graph));
  EXPECT_DOUBLE_EQ(Topology(graph).PathsFrom({1, 0}).at({0, 0}), 5.);
}

}  // namespace
}  // namespace cartographer::pose_graph
