// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// Graphs that are small, broken or without information; limits; threads.

#include <gtest/gtest.h>

#include <limits>

#include "cartographer/pose_graph/optimize_graph.h"
#include "cartographer/transform/se3_jacobian.h"
#include "tbb/global_control.h"
#include "tbb/task_arena.h"
#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;

class OptimizeHardGraphTest : public ::testing::Test {
 protected:
  const proto::OptimizationOptions options_ = OptimizationDefaults();
  const Poses truth_ = Laps(2.);
};

TEST_F(OptimizeHardGraphTest, ASingleNodeInItsOwnSubmapStays) {
  Graph graph;
  AddTrajectory(0, {truth_.front()}, &graph);
  graph.constraints.push_back(
      TrueLoop(graph, SubmapId{0, 0}, {truth_.front()}, NodeId{0, 0}, truth_));
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_EQ(report.num_loops, 1);
  EXPECT_LT(LargestError_m(graph, 0, {truth_.front()}), 1e-9);
}

TEST_F(OptimizeHardGraphTest, StandingStillIsNoTrouble) {
  const Poses still(60, truth_.front());
  Graph graph;
  AddTrajectory(0, still, &graph);
  for (int i = 30; i < 60; ++i) {
    graph.constraints.push_back(TrueLoop(graph, SubmapId{0, 1}, still, NodeId{0, i}, still));
  }
  const OptimizationReport report = OptimizeGraph(options_, &graph);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(LargestError_m(graph, 0, still), 1e-9);
}

TEST_F(OptimizeHardGraphTest, NumbersThatAreNoneDoNotSpread) {
  Graph graph = DriftedGraph(truth_, RandomErrors());
  Graph clean = graph;
  Constraint broken = graph.constraints.back();
  broken.submap_from_node =
      Rigid3d::Translation({std::numeric_limits<double>::quiet_NaN(), 0., 0.});
  graph.constraints.push_back(broken);
  OptimizeGraph(options_, &graph);
  OptimizeGraph(options_, &clean);
  EXPECT_EQ(Bytes(graph), Bytes(clean));
}

TEST_F(OptimizeHardGraphTest, HugeNumbersDoNotBecomeNoNumbers) {
  Graph graph = DriftedGraph(truth_, RandomErrors());
  graph.constraints.back().submap_from_node = Rigid3d::Translation({1e9, 0., 0.});
  EXPECT_EQ(OptimizeGraph(options_, &graph).num_rejected, 1);
  for (const auto& [id, node] : graph.nodes) ASSERT_TRUE(node.map_from_node.IsFinite());
}

TEST_F(OptimizeHardGraphTest, LoopsThatSayNothingMoveNothing) {
  Graph graph = DriftedGraph(truth_, RandomErrors());
  for (Constraint& constraint : graph.constraints) {
    constraint.information = transform::Matrix6d::Zero();
  }
  Poses before;
  for (const auto& [id, node] : graph.nodes) before.push_back(node.map_from_node);
  EXPECT_TRUE(OptimizeGraph(options_, &graph).converged);
  EXPECT_LT(LargestError_m(graph, 0, before), 1e-8);
}

TEST_F(OptimizeHardGraphTest, StopsAtTheLimitOfIterations) {
  auto options = options_;
  options.set_max_iterations(1);
  Graph graph = DriftedGraph(truth_, RandomErrors());
  const OptimizationReport report = OptimizeGraph(options, &graph);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_LT(report.final_cost, report.initial_cost);
}

TEST_F(OptimizeHardGraphTest, GivesTheSameBytesOnAnyNumberOfThreads) {
  std::string expected;
  for (const int num_threads : {1, 2, 8}) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, num_threads);
    tbb::task_arena arena(num_threads);
    Graph graph = DriftedGraph(truth_, RandomErrors());
    arena.execute([&] { OptimizeGraph(options_, &graph); });
    if (expected.empty()) expected = Bytes(graph);
    EXPECT_EQ(Bytes(graph), expected) << num_threads;
  }
}

}  // namespace
}  // namespace cartographer::pose_graph
