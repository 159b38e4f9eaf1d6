// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graph_selection.h"

#include <cmath>
#include <limits>

#include "cartographer/transform/se3_jacobian.h"
#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using submap::SubmapId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class GraphSelectionTest : public ::testing::Test {
 protected:
  GraphSelectionTest() {
    for (const int id : {1, 2, 3, 4}) AddTrajectory(id, truth_, &graph_);
  }
  void AddLoop(int of_submap, int of_node) {
    graph_.constraints.push_back(
        TrueLoop(graph_, SubmapId{of_submap, 0}, truth_, NodeId{of_node, 20}, truth_));
  }

  const Poses truth_ = Laps(0.2);
  Graph graph_;
};

TEST_F(GraphSelectionTest, IsEmptyWithoutLoops) {
  const GraphSelection selection = SelectFrom(graph_);
  EXPECT_THAT(selection.loops, IsEmpty());
  EXPECT_THAT(selection.moving, IsEmpty());
  EXPECT_THAT(selection.anchored, IsEmpty());
  EXPECT_THAT(SelectFrom(Graph()).loops, IsEmpty());
}

TEST_F(GraphSelectionTest, AnchorsTheFirstTrajectoryOfEachGroup) {
  AddLoop(4, 2);
  AddLoop(3, 3);
  const GraphSelection selection = SelectFrom(graph_);
  EXPECT_EQ(selection.loops.size(), 2);
  EXPECT_THAT(selection.moving, ElementsAre(2, 3, 4));
  EXPECT_THAT(selection.anchored, ElementsAre(2, 3));
}

TEST_F(GraphSelectionTest, FollowsChainsOfTies) {
  AddLoop(4, 3);
  AddLoop(1, 4);
  AddLoop(2, 3);
  EXPECT_THAT(SelectFrom(graph_).anchored, ElementsAre(1));
}

TEST_F(GraphSelectionTest, AnchorsNothingThatAFrozenTrajectoryHolds) {
  graph_.frozen_trajectories = {3};
  AddLoop(3, 2);
  AddLoop(2, 1);
  AddLoop(4, 4);
  const GraphSelection selection = SelectFrom(graph_);
  EXPECT_THAT(selection.moving, ElementsAre(1, 2, 4));
  EXPECT_THAT(selection.anchored, ElementsAre(4));
  EXPECT_EQ(selection.ties.count(SubmapId{3, 0}), 0);
}

TEST_F(GraphSelectionTest, IgnoresLoopsAmongTheFrozen) {
  graph_.frozen_trajectories = {3, 4};
  AddLoop(3, 4);
  AddLoop(3, 3);
  EXPECT_THAT(SelectFrom(graph_).loops, IsEmpty());
}

TEST_F(GraphSelectionTest, HangsSubmapsOnTheirMiddleNode) {
  const SubmapTie tie = SelectFrom(graph_).ties.at(SubmapId{2, 1});  // of the nodes 5 ... 14
  EXPECT_EQ(tie.node_id, (NodeId{2, 10}));
  const transform::Rigid3d expected =
      graph_.submaps.at(SubmapId{2, 1}).map_from_submap.inverse() * truth_[10];
  EXPECT_LT((tie.submap_from_node.Matrix() - expected.Matrix()).norm(), 1e-12);
}

TEST_F(GraphSelectionTest, IgnoresLoopsWhoseEndsAreMissing) {
  AddLoop(1, 1);
  AddLoop(2, 2);
  AddLoop(3, 3);
  graph_.nodes.erase(NodeId{1, 20});
  graph_.submaps.erase(SubmapId{2, 0});
  for (int i = 0; i < 10; ++i) graph_.nodes.erase(NodeId{3, i});  // all that are in the submap
  EXPECT_THAT(SelectFrom(graph_).loops, IsEmpty());
}

TEST_F(GraphSelectionTest, IgnoresLoopsThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  AddLoop(1, 1);
  graph_.constraints.back().translation_weight = kNan;
  AddLoop(1, 1);
  graph_.constraints.back().rotation_weight = std::numeric_limits<double>::infinity();
  AddLoop(1, 1);
  graph_.constraints.back().submap_from_node = transform::Rigid3d::Translation({0., kNan, 0.});
  AddLoop(1, 1);
  graph_.constraints.back().information = transform::Matrix6d::Constant(kNan);
  EXPECT_THAT(SelectFrom(graph_).loops, IsEmpty());
}

TEST_F(GraphSelectionTest, IgnoresLoopsOfTrajectoriesThatAreNotFinite) {
  AddLoop(1, 1);
  AddLoop(2, 1);
  AddLoop(3, 3);
  const double infinity = std::numeric_limits<double>::infinity();
  graph_.nodes.at(NodeId{1, 7}).local_from_node =
      transform::Rigid3d::Translation({infinity, 0., 0.});
  EXPECT_THAT(SelectFrom(graph_).moving, ElementsAre(3));
  graph_.submaps.at(SubmapId{3, 0}).map_from_submap =
      transform::Rigid3d::Translation({infinity, 0., 0.});
  EXPECT_THAT(SelectFrom(graph_).moving, IsEmpty());
}

}  // namespace
}  // namespace cartographer::pose_graph
