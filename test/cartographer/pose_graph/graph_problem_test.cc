// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graph_problem.h"

#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using submap::SubmapId;

OdometryErrors SomeErrors() {
  OdometryErrors errors;
  errors.twist_per_m << 1e-3, -1e-3, 2e-3, 2e-5, -1e-5, 3e-5;
  errors.sigmas_per_sqrt_m << 0.01, 0.01, 0.01, 2e-4, 2e-4, 2e-4;
  return errors;
}

Graph Solved(const proto::OptimizationOptions& options, const Graph& graph) {
  const GraphSelection selection = SelectFrom(graph);
  std::map<int, OdometryChain> chains;
  for (const int id : selection.moving) chains.try_emplace(id, options.odometry(), graph, id);
  GraphProblem problem(options, graph, selection, chains);
  const std::vector<double> weights(selection.loops.size(), 1.);
  GraphProblem::Progress progress{};
  // Ceres stops when a step gains little; here it has to be the minimum itself.
  for (int i = 0; i < 5; ++i) progress = problem.Solve(weights, 100);
  EXPECT_TRUE(progress.usable);
  EXPECT_TRUE(progress.converged);
  Graph result = graph;
  problem.WriteTo(&result);
  return result;
}

// A loop that says nothing makes an unknown of its node. With one at every node nothing is put
// together and nothing filled in: the solution must be the same.
TEST(GraphProblemTest, LeavingNodesOutDoesNotChangeTheSolution) {
  const proto::OptimizationOptions options = OptimizationDefaults();
  const Poses truth = Laps(1.3);
  Graph graph;
  AddTrajectory(0, WithErrors(truth, SomeErrors()), &graph);
  AddTrueLoops(0, truth, 1., &graph);
  Graph in_full = graph;
  for (const auto& [id, node] : graph.nodes) {
    submap::Constraint silent = TrueLoop(graph, SubmapId{0, 0}, truth, id, truth);
    silent.translation_weight = 0.;
    silent.rotation_weight = 0.;
    in_full.constraints.push_back(silent);
  }
  graph = Solved(options, graph);
  in_full = Solved(options, in_full);
  double largest_m = 0., largest_rad = 0.;
  for (const auto& [id, node] : graph.nodes) {
    const transform::Rigid3d difference =
        node.map_from_node.inverse() * in_full.nodes.at(id).map_from_node;
    largest_m = std::max(largest_m, difference.translation().norm());
    largest_rad = std::max(largest_rad, transform::RotationAngle(difference));
  }
  EXPECT_LT(largest_m, 2e-4);
  EXPECT_LT(largest_rad, 1e-5);
}

TEST(GraphProblemTest, CostsAreSquaredErrorsInStandardDeviations) {
  const proto::OptimizationOptions options = OptimizationDefaults();
  const Poses truth = Laps(1.3);
  Graph graph;
  AddTrajectory(0, truth, &graph);
  AddTrueLoops(0, truth, 1., &graph);
  auto& loop = graph.constraints.back();
  loop.submap_from_node =
      loop.submap_from_node * transform::Rigid3d::Translation({0.05, 0., 2. * 0.05});
  const GraphSelection selection = SelectFrom(graph);
  std::map<int, OdometryChain> chains;
  chains.try_emplace(0, options.odometry(), graph, 0);
  GraphProblem problem(options, graph, selection, chains);
  const std::vector<double> errors = problem.SquaredLoopErrors();
  ASSERT_GT(errors.size(), 5);
  EXPECT_NEAR(errors.back(), 1. + 4., 1e-6);
  EXPECT_NEAR(errors.front(), 0., 1e-9);
  EXPECT_NEAR(problem.CostWithoutLoops(), 0., 1e-9);
  // The weights of the last solution do not stick.
  problem.Solve(std::vector<double>(errors.size(), 0.), 10);
  EXPECT_NEAR(problem.SquaredLoopErrors().back(), 5., 1e-6);
}

}  // namespace
}  // namespace cartographer::pose_graph
