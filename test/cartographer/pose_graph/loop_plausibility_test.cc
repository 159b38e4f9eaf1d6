// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/loop_plausibility.h"

#include <algorithm>

#include "cartographer/pose_graph/odometry_uncertainty.h"
#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using submap::SubmapId;
using ::testing::Each;
using transform::Rigid3d;

class LoopPlausibilityTest : public ::testing::Test {
 protected:
  LoopPlausibilityTest() { AddTrajectory(0, truth_, &graph_); }

  // Off by `error`, in the frame of the submap.
  void AddLoop(int node, const Rigid3d& error) {
    graph_.constraints.push_back(TrueLoop(graph_, SubmapId{0, 2}, truth_, NodeId{0, node}, truth_));
    auto& submap_from_node = graph_.constraints.back().submap_from_node;
    submap_from_node = error * submap_from_node;
  }
  std::vector<bool> Judge(int dof = 6) const {
    auto options = options_;
    options.set_dof(dof);
    const GraphSelection selection = SelectFrom(graph_);
    std::map<int, OdometryChain> chains;
    for (const int id : selection.moving) chains.try_emplace(id, options.odometry(), graph_, id);
    return FindPlausibleLoops(options, selection, chains);
  }
  // What the odometry may be off by between the submap's middle and the node.
  double Sigma_m(int node) const {
    const OdometryChain chain(options_.odometry(), graph_, 0);
    return std::sqrt(
        OdometryUncertainty(options_.odometry(), chain).Between(15, node).translation_m2);
  }

  const proto::OptimizationOptions options_ = OptimizationDefaults();
  const double scale_ = options_.loop_scale_sigmas();
  const Poses truth_ = Laps(2.);
  Graph graph_;
};

TEST_F(LoopPlausibilityTest, BelievesWhatTheOdometryMayHaveBeenWrongBy) {
  AddLoop(135, Rigid3d::Translation({0.9 * scale_ * Sigma_m(135), 0., 0.}));
  EXPECT_THAT(Judge(), Each(true));
}

TEST_F(LoopPlausibilityTest, DoubtsALonelyLoopThatIsFartherOff) {
  AddLoop(135, Rigid3d::Translation({0., 1.2 * scale_ * Sigma_m(135), 0.}));
  EXPECT_THAT(Judge(), Each(false));
}

TEST_F(LoopPlausibilityTest, DoubtsALonelyLoopThatIsTurned) {
  AddLoop(135,
          Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()))));
  EXPECT_THAT(Judge(), Each(false));
}

TEST_F(LoopPlausibilityTest, BelievesManyThatSayTheSame) {
  const Rigid3d jump = Rigid3d::Translation({0., 0., 4.5 * scale_ * Sigma_m(135)});
  for (int node = 131; node < 135; ++node) AddLoop(node, jump);
  EXPECT_THAT(Judge(), Each(false));
  AddLoop(135, jump);
  EXPECT_THAT(Judge(), Each(true));
}

TEST_F(LoopPlausibilityTest, BelievesTheEdgesOfAGroupToo) {
  const Rigid3d jump = Rigid3d::Translation({0., 0., 9.5 * scale_ * Sigma_m(135)});
  // Each has up to five neighbours on either side.
  for (int node = 130; node < 190; node += 3) AddLoop(node, jump);
  EXPECT_THAT(Judge(), Each(true));
}

TEST_F(LoopPlausibilityTest, AsksOnlyTheNeighbours) {
  const Rigid3d jump = Rigid3d::Translation({0., 0., 4.5 * scale_ * Sigma_m(135)});
  for (int node = 131; node < 135; ++node) AddLoop(node, jump);
  AddLoop(165, jump);  // some 90 m on
  EXPECT_THAT(Judge(), Each(false));
}

TEST_F(LoopPlausibilityTest, DoubtsManyThatContradictEachOther) {
  const double far_m = 1.5 * scale_ * Sigma_m(135);
  for (int i = 0; i < 10; ++i) {
    const double angle = 2.4 * i;
    AddLoop(131 + i, Rigid3d::Translation({far_m * std::cos(angle), far_m * std::sin(angle), 0.}));
  }
  EXPECT_THAT(Judge(), Each(false));
}

TEST_F(LoopPlausibilityTest, TellsTheWrongOneFromTheRightOnes) {
  for (int node = 131; node < 137; ++node) AddLoop(node, Rigid3d());
  AddLoop(137, Rigid3d::Translation({30., 0., 0.}));
  std::vector<bool> expected(6, true);
  expected.push_back(false);
  EXPECT_EQ(Judge(), expected);
}

TEST_F(LoopPlausibilityTest, DoesNotLookAtHeightAndTiltInThePlane) {
  AddLoop(135, Rigid3d::Translation({0., 0., 2. * scale_ * Sigma_m(135)}));
  EXPECT_THAT(Judge(6), Each(false));
  EXPECT_THAT(Judge(3), Each(true));
}

TEST_F(LoopPlausibilityTest, BelievesLoopsBetweenTrajectories) {
  AddTrajectory(1, truth_, &graph_);
  graph_.constraints.push_back(TrueLoop(graph_, SubmapId{0, 2}, truth_, NodeId{1, 100}, truth_));
  graph_.constraints.back().submap_from_node = Rigid3d::Translation({100., 0., 0.});
  EXPECT_THAT(Judge(), Each(true));
}

TEST_F(LoopPlausibilityTest, BelievesLoopsThatClaimToKnowNothing) {
  AddLoop(135, Rigid3d::Translation({100., 0., 0.}));
  graph_.constraints.back().translation_weight = 0.;
  graph_.constraints.back().rotation_weight = 0.;
  EXPECT_THAT(Judge(), Each(true));
}

}  // namespace
}  // namespace cartographer::pose_graph
