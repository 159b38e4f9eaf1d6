// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/optimize_graph.h"

#include <algorithm>
#include <vector>

#include "cartographer/pose_graph/graph_problem.h"
#include "cartographer/pose_graph/graph_selection.h"

namespace cartographer::pose_graph {
namespace {

double Square(double x) { return x * x; }

}  // namespace

OptimizationReport OptimizeGraph(const proto::OptimizationOptions& options, Graph* graph) {
  OptimizationReport report;
  const GraphSelection selection = SelectFrom(*graph);
  report.num_loops = selection.loops.size();
  if (selection.loops.empty()) return report;
  GraphProblem problem(options, *graph, selection);
  const double scale2 = Square(options.loop_scale_sigmas()) * options.dof();
  const auto robust_cost = [&](const std::vector<double>& errors) {
    double cost = problem.CostWithoutLoops();
    for (const double e : errors) cost += 0.5 * scale2 * e / (scale2 + e);
    return cost;
  };
  std::vector<double> errors = problem.SquaredLoopErrors();
  report.initial_cost = robust_cost(errors);
  report.final_cost = report.initial_cost;
  double mu = 1e100;
  std::vector<double> weights(errors.size());
  while (report.iterations < options.max_iterations()) {
    const double worst = *std::max_element(errors.begin(), errors.end());
    const bool was_last = mu == 1.;
    mu = std::max(1., std::min(mu / 4., 2. * worst / scale2));
    for (size_t i = 0; i < errors.size(); ++i) {
      weights[i] = Square(mu * scale2 / (mu * scale2 + errors[i]));
    }
    const auto progress = problem.Solve(weights, mu == 1. ? 20 : 3);
    report.iterations += progress.iterations;
    errors = problem.SquaredLoopErrors();
    const double cost = robust_cost(errors);
    const bool settled = was_last && std::abs(cost - report.final_cost) < 1e-4 * cost;
    report.final_cost = cost;
    report.converged = settled && progress.usable;
    if (settled) break;
  }
  for (const double w : weights) report.num_rejected += w < 0.1;
  problem.WriteTo(graph);
  report.twist_per_m = problem.TwistsPerMetre();
  return report;
}

}  // namespace cartographer::pose_graph
