// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/optimize_graph.h"

#include <cmath>

#include "cartographer/pose_graph/graph_selection.h"
#include "cartographer/transform/se3_jacobian.h"
#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;
using transform::Twist;

OdometryErrors SystematicErrors() {
  OdometryErrors errors;
  errors.twist_per_m << 0., 0., 0., 0., 3e-5, -6e-5;
  return errors;
}

// For odometry that has no others.
proto::OptimizationOptions ForSystematicErrors() {
  return OptimizationDefaults(R"(
      local function sigmas(m, up, t, y)
        return { forward_m = m, left_m = m, up_m = up, tilt_deg = t, heading_deg = y }
      end
      OPTIMIZATION.odometry.random = sigmas(0.001, 0.001, 0.001, 0.001)
      OPTIMIZATION.odometry.systematic = sigmas(0.001, 0.001, 0.003, 0.003))");
}

class OptimizeGraphTest : public ::testing::Test {
 protected:
  Graph DriftedGraph(const OdometryErrors& errors, double min_laps = 1.) const {
    return pose_graph::DriftedGraph(truth_, errors, min_laps);
  }

  const proto::OptimizationOptions options_ = OptimizationDefaults();
  const Poses truth_ = Laps(2.);
};

TEST_F(OptimizeGraphTest, NothingMovesInAnEmptyGraph) {
  Graph graph;
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.num_loops, 0);
}

TEST_F(OptimizeGraphTest, WithoutLoopsNothingMoves) {
  Graph graph;
  AddTrajectory(0, WithErrors(truth_, RandomErrors()), &graph);
  const std::string before = Bytes(graph);
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(Bytes(graph), before);
}

TEST_F(OptimizeGraphTest, APerfectGraphDoesNotMove) {
  Graph graph = DriftedGraph(OdometryErrors());
  const Graph before = graph;
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_GT(report.num_loops, 20);
  EXPECT_EQ(report.num_rejected, 0);
  EXPECT_NEAR(report.final_cost, 0., 1e-9);
  EXPECT_LT(LargestError_m(graph, 0, truth_), 1e-8);
  for (const auto& [id, submap] : graph.submaps) {
    EXPECT_LT(
        (submap.map_from_submap.Matrix() - before.submaps.at(id).map_from_submap.Matrix()).norm(),
        1e-8);
  }
}

TEST_F(OptimizeGraphTest, ExactLoopsTakeMostOfTheErrorAway) {
  Graph graph = DriftedGraph(RandomErrors());
  const double before_m = LargestError_m(graph, 0, truth_);
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.num_rejected, 0);
  EXPECT_LT(report.final_cost, 0.15 * report.initial_cost);
  EXPECT_GT(before_m, 1.5);
  EXPECT_LT(LargestError_m(graph, 0, truth_), 0.5 * before_m);
  // The second lap lies on the first.
  for (int i = 0; i < kNodesPerLap; ++i) {
    const Rigid3d& first = graph.nodes.at(NodeId{0, i}).map_from_node;
    const Rigid3d& second = graph.nodes.at(NodeId{0, i + kNodesPerLap}).map_from_node;
    EXPECT_LT((first.translation() - second.translation()).norm(), 0.2) << i;
  }
}

TEST_F(OptimizeGraphTest, FindsTheSystematicErrorAndRemovesItsDrift) {
  Graph graph = DriftedGraph(SystematicErrors());
  const double before_m = LargestError_m(graph, 0, truth_);
  const OptimizationReport report = OptimizeGraph(ForSystematicErrors(), &graph);
  EXPECT_TRUE(report.converged);
  const Twist found = report.correction_per_m.at(0);
  const Twist expected = -SystematicErrors().twist_per_m;
  for (const int axis : {3, 4, 5}) EXPECT_NEAR(found[axis], expected[axis], 1e-5) << axis;
  EXPECT_GT(before_m, 2.);
  EXPECT_LT(LargestError_m(graph, 0, truth_), 0.1 * before_m);
}

// A loop at the beginning teaches what the rest of the drive, which has none, profits from.
TEST_F(OptimizeGraphTest, WhatLoopsTeachHelpsWhereThereAreNone) {
  const Poses truth = Laps(3.5);
  Graph drifted;
  AddTrajectory(0, WithErrors(truth, SystematicErrors()), &drifted);
  AddTrueLoops(0, Poses(truth.begin(), truth.begin() + 2 * kNodesPerLap), 1., &drifted);
  Graph with = drifted, without = drifted;
  OptimizeGraph(ForSystematicErrors(), &with);
  auto only_random = ForSystematicErrors();
  only_random.mutable_odometry()->mutable_systematic()->Clear();
  const OptimizationReport report = OptimizeGraph(only_random, &without);
  EXPECT_EQ(report.correction_per_m.at(0), Twist::Zero());
  EXPECT_LT(LargestError_m(with, 0, truth), 0.5 * LargestError_m(without, 0, truth));
}

TEST_F(OptimizeGraphTest, TheFirstNodeStays) {
  Graph graph = DriftedGraph(RandomErrors());
  const Rigid3d before = graph.nodes.at(NodeId{0, 0}).map_from_node;
  OptimizeGraph(options_, &graph);
  EXPECT_EQ(graph.nodes.at(NodeId{0, 0}).map_from_node.Matrix(), before.Matrix());
}

TEST_F(OptimizeGraphTest, SubmapsStayWithTheirNodes) {
  Graph graph = DriftedGraph(RandomErrors());
  OptimizeGraph(options_, &graph);
  const GraphSelection selection = SelectFrom(graph);
  for (const auto& [submap_id, tie] : selection.ties) {
    const Rigid3d difference = graph.submaps.at(submap_id).map_from_submap * tie.submap_from_node *
                               graph.nodes.at(tie.node_id).map_from_node.inverse();
    const Rigid3d in_node = graph.nodes.at(tie.node_id).map_from_node.inverse() *
                            graph.submaps.at(submap_id).map_from_submap * tie.submap_from_node;
    EXPECT_LT(in_node.translation().norm(), 0.05) << difference.DebugString();
    EXPECT_LT(transform::RotationAngle(in_node), 2e-3);
  }
}

TEST_F(OptimizeGraphTest, OptimizingAgainChangesLittle) {
  Graph graph = DriftedGraph(RandomErrors());
  OptimizeGraph(options_, &graph);
  Poses first;
  for (const auto& [id, node] : graph.nodes) first.push_back(node.map_from_node);
  const OptimizationReport again = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(again.converged);
  EXPECT_LT(LargestError_m(graph, 0, first), 1e-3);
}

TEST_F(OptimizeGraphTest, InThePlaneHeightsAndTiltsStay) {
  auto planar = options_;
  planar.set_dof(3);
  Graph graph = DriftedGraph(RandomErrors());
  const Graph before = graph;
  const OptimizationReport report = OptimizeGraph(planar, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.num_rejected, 0);
  const auto expect_same_height_and_tilt = [](const Rigid3d& a, const Rigid3d& b) {
    EXPECT_EQ(a.translation().z(), b.translation().z());
    EXPECT_LT((a.rotation().conjugate() * Eigen::Vector3d::UnitZ() -
               b.rotation().conjugate() * Eigen::Vector3d::UnitZ())
                  .norm(),
              1e-13);
  };
  double apart_m = 0., apart_before_m = 0.;
  for (const auto& [id, node] : graph.nodes) {
    expect_same_height_and_tilt(node.map_from_node, before.nodes.at(id).map_from_node);
    if (id.node_index < kNodesPerLap) continue;
    const NodeId lap_before{0, id.node_index - kNodesPerLap};
    const auto distance = [&](const Graph& in) {
      return (in.nodes.at(id).map_from_node.translation() -
              in.nodes.at(lap_before).map_from_node.translation())
          .head<2>()
          .norm();
    };
    apart_m = std::max(apart_m, distance(graph));
    apart_before_m = std::max(apart_before_m, distance(before));
  }
  for (const auto& [id, submap] : graph.submaps) {
    expect_same_height_and_tilt(submap.map_from_submap, before.submaps.at(id).map_from_submap);
  }
  EXPECT_GT(apart_before_m, 1.);
  EXPECT_LT(apart_m, 0.2);
}

TEST_F(OptimizeGraphTest, InThePlaneWhatIsLevelEndsWhereItDoesInSpace) {
  Poses level = truth_;
  for (Rigid3d& pose : level) {
    pose = transform::Level(pose);
    pose = Rigid3d({pose.translation().x(), pose.translation().y(), 0.}, pose.rotation());
  }
  OdometryErrors errors;
  errors.twist_per_m[5] = 2e-5;
  errors.sigmas_per_sqrt_m << 0.02, 0.02, 0., 0., 0., 5e-4;
  Graph in_space;
  AddTrajectory(0, WithErrors(level, errors), &in_space);
  AddTrueLoops(0, level, 1., &in_space);
  Graph in_plane = in_space;
  auto planar = options_;
  planar.set_dof(3);
  // So that the same errors weigh the same: the kernel's scale is per degree of freedom.
  planar.set_loop_scale_sigmas(options_.loop_scale_sigmas() * std::sqrt(2.));
  OptimizeGraph(options_, &in_space);
  OptimizeGraph(planar, &in_plane);
  Poses poses_in_space;
  for (const auto& [id, node] : in_space.nodes) poses_in_space.push_back(node.map_from_node);
  EXPECT_LT(LargestError_m(in_plane, 0, poses_in_space), 0.01);
}

TEST_F(OptimizeGraphTest, WrongLoopsAmongRightOnesDoNotBendTheMap) {
  Graph graph = DriftedGraph(RandomErrors());
  Graph without = graph;
  OptimizeGraph(options_, &without);
  Poses expected;
  for (const auto& [id, node] : without.nodes) expected.push_back(node.map_from_node);
  // Another street that looks alike, a mirrored crossing, a jump in height.
  const Rigid3d wrongs[] = {
      Rigid3d::Translation({25., 5., 0.}),
      Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()))),
      Rigid3d::Translation({0., 0., 4.})};
  int node = 2 * kNodesPerLap - 50;
  for (const Rigid3d& wrong : wrongs) {
    Constraint loop = TrueLoop(graph, SubmapId{0, 4}, truth_, NodeId{0, node}, truth_);
    loop.submap_from_node = loop.submap_from_node * wrong;
    graph.constraints.push_back(loop);
    node += 7;
  }
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.num_rejected, 3);
  EXPECT_LT(LargestError_m(graph, 0, expected), 0.02);
}

TEST_F(OptimizeGraphTest, ALonelyWrongLoopDoesNotBendTheMap) {
  Graph graph;
  AddTrajectory(0, WithErrors(truth_, RandomErrors()), &graph);
  const Graph before = graph;
  Constraint loop = TrueLoop(graph, SubmapId{0, 4}, truth_, NodeId{0, 200}, truth_);
  loop.submap_from_node = loop.submap_from_node * Rigid3d::Translation({40., 0., 0.});
  graph.constraints.push_back(loop);
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_EQ(report.num_rejected, 1);
  Poses odometry;
  for (const auto& [id, node] : before.nodes) odometry.push_back(node.map_from_node);
  EXPECT_LT(LargestError_m(graph, 0, odometry), 0.02);
}

TEST_F(OptimizeGraphTest, AJumpOfTheOdometryIsClosedByLoopsThatAgree) {
  constexpr int kJump = 90;
  constexpr int kEnd = kNodesPerLap + kJump - 10;
  Poses odometry = WithErrors(Poses(truth_.begin(), truth_.begin() + kEnd), RandomErrors());
  for (int i = kJump; i < kEnd; ++i) {
    odometry[i] = Rigid3d::Translation({4., -3., 2.}) * odometry[i];
  }
  Graph graph;
  AddTrajectory(0, odometry, &graph);
  AddTrueLoops(0, Poses(truth_.begin(), truth_.begin() + kEnd), 1., &graph);
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.num_rejected, 0);
  for (int i = kNodesPerLap; i < kEnd; ++i) {
    EXPECT_LT((graph.nodes.at(NodeId{0, i}).map_from_node.translation() -
               graph.nodes.at(NodeId{0, i - kNodesPerLap}).map_from_node.translation())
                  .norm(),
              0.6)
        << i;
  }
}

TEST_F(OptimizeGraphTest, WhatIsFrozenStaysAndTheNewComesToIt) {
  Graph graph;
  AddTrajectory(0, truth_, &graph);
  graph.frozen_trajectories = {0};
  const std::string frozen = Bytes(graph);
  // A new drive whose odometry begins elsewhere.
  Poses elsewhere = WithErrors(Laps(1.), RandomErrors());
  for (Rigid3d& pose : elsewhere) {
    pose = Rigid3d({3., -2., 1.},
                   Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()))) *
           pose;
  }
  AddTrajectory(1, elsewhere, &graph);
  for (int i = 2; i < kNodesPerLap; i += 6) {
    graph.constraints.push_back(
        TrueLoop(graph, SubmapId{0, i / 6}, truth_, NodeId{1, i}, Laps(1.)));
    graph.constraints.push_back(
        TrueLoop(graph, SubmapId{1, i / 6}, Laps(1.), NodeId{0, i}, truth_));
  }
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.num_rejected, 0);
  EXPECT_LT(LargestError_m(graph, 1, Laps(1.)), 0.2);
  for (int index = 0; index < 20; ++index) graph.submaps.erase(SubmapId{1, index});
  Graph only_frozen = graph;
  only_frozen.nodes.erase(only_frozen.nodes.lower_bound(NodeId{1, 0}), only_frozen.nodes.end());
  only_frozen.submaps.erase(only_frozen.submaps.lower_bound(SubmapId{1, 0}),
                            only_frozen.submaps.end());
  EXPECT_EQ(Bytes(only_frozen), frozen);
}

TEST_F(OptimizeGraphTest, TrajectoriesThatAreNotTiedAreOptimizedAsIfAlone) {
  Graph alone[2], together;
  for (const int id : {0, 1}) {
    OdometryErrors errors = RandomErrors();
    errors.seed = 10 + id;
    for (Graph* graph : {&alone[id], &together}) {
      AddTrajectory(id, WithErrors(truth_, errors), graph);
      AddTrueLoops(id, truth_, 1., graph);
    }
    OptimizeGraph(options_, &alone[id]);
  }
  OptimizeGraph(options_, &together);
  for (const int id : {0, 1}) {
    Poses expected;
    for (const auto& [node_id, node] : alone[id].nodes) expected.push_back(node.map_from_node);
    EXPECT_LT(LargestError_m(together, id, expected), 1e-3);
    EXPECT_EQ(together.nodes.at(NodeId{id, 0}).map_from_node.Matrix(), truth_.front().Matrix());
  }
}

TEST_F(OptimizeGraphTest, ATrajectoryWithoutLoopsStaysBesideOneThatMoves) {
  Graph graph = DriftedGraph(RandomErrors());
  Graph other;
  AddTrajectory(1, WithErrors(truth_, RandomErrors()), &other);
  const std::string before = Bytes(other);
  graph.nodes.insert(other.nodes.begin(), other.nodes.end());
  graph.submaps.insert(other.submaps.begin(), other.submaps.end());
  graph.constraints.insert(graph.constraints.end(), other.constraints.begin(),
                           other.constraints.end());
  OptimizeGraph(options_, &graph);
  for (auto& [id, node] : other.nodes) node = graph.nodes.at(id);
  for (auto& [id, submap] : other.submaps) submap = graph.submaps.at(id);
  EXPECT_EQ(Bytes(other), before);
}

}  // namespace
}  // namespace cartographer::pose_graph
