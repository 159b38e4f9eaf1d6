// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/join_groups.h"

#include <gtest/gtest.h>

#include "test/cartographer/pose_graph/small_drive.h"

namespace cartographer::pose_graph {
namespace {

using transform::Rigid3d;

const Rigid3d kWanted({3., -2., 0.5},
                      Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ())));

Graph TwoDrives() {
  Graph graph;
  AddDrive(0, OutAndBack(20, 4.), 10, &graph);
  AddDrive(1, OutAndBack(20, 4.), 10, &graph);
  return graph;
}

Rigid3d Where(const Graph& graph, int trajectory_id, int node) {
  return graph.nodes.at({trajectory_id, node}).map_from_node;
}

TEST(JoinGroupsTest, TheLaterDriveMovesAsAWhole) {
  const Graph before = TwoDrives();
  Graph graph = before;
  ASSERT_TRUE(JoinGroups(ClosureBetween({0, 0}, {1, 5}, kWanted, graph), &graph));
  EXPECT_LT((Where(graph, 1, 5).translation() - kWanted.translation()).norm(), 1e-9);
  EXPECT_NEAR(transform::Yaw(Where(graph, 1, 5).rotation()), 1.2, 1e-9);
  const Rigid3d step = Where(graph, 1, 5).inverse() * Where(graph, 1, 30);
  const Rigid3d same = Where(before, 1, 5).inverse() * Where(before, 1, 30);
  EXPECT_LT((step.translation() - same.translation()).norm(), 1e-9);
  EXPECT_EQ(Where(graph, 0, 7).translation(), Where(before, 0, 7).translation());
}

TEST(JoinGroupsTest, FrozenOnesStay) {
  const Graph before = TwoDrives();
  Graph graph = before;
  graph.frozen_trajectories = {1};
  ASSERT_TRUE(JoinGroups(ClosureBetween({0, 0}, {1, 5}, kWanted, graph), &graph));
  EXPECT_EQ(Where(graph, 1, 5).translation(), Where(before, 1, 5).translation());
  EXPECT_GT((Where(graph, 0, 5).translation() - Where(before, 0, 5).translation()).norm(), 0.1);
  graph.frozen_trajectories = {0, 1};
  EXPECT_FALSE(JoinGroups(ClosureBetween({0, 0}, {1, 5}, kWanted, graph), &graph));
}

TEST(JoinGroupsTest, WhatIsTiedDoesNotMove) {
  Graph graph = TwoDrives();
  graph.constraints.push_back(ClosureBetween({0, 1}, {1, 12}, Where(graph, 1, 12), graph));
  EXPECT_FALSE(JoinGroups(ClosureBetween({0, 0}, {1, 5}, kWanted, graph), &graph));
  EXPECT_FALSE(JoinGroups(ClosureBetween({0, 0}, {0, 15}, kWanted, graph), &graph));
}

}  // namespace
}  // namespace cartographer::pose_graph
