// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/optimize_graph.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cartographer/pose_graph/graduated_kernel.h"
#include "cartographer/pose_graph/graph_problem.h"
#include "cartographer/pose_graph/graph_selection.h"
#include "cartographer/pose_graph/loop_plausibility.h"

namespace cartographer::pose_graph {
namespace {

// Steps to take before the kernel is narrowed again, and once it is as narrow as it gets.
constexpr int kStepsPerWidth = 3;
constexpr int kLastSteps = 20;
// The weights have settled when solving again lowers the cost by less than this share.
constexpr double kSettled = 1e-4;
constexpr double kRejectedWeight = 0.1;

GraduatedKernel MakeKernel(const proto::OptimizationOptions& options) {
  const double scale = options.loop_scale_sigmas();
  return GraduatedKernel(scale * scale * (options.dof() < 6 ? 3 : 6));
}

double RobustCost(const GraduatedKernel& kernel, const std::vector<double>& errors,
                  GraphProblem* problem) {
  double cost = problem->CostWithoutLoops();
  for (const double error : errors) cost += kernel.Cost(error);
  return cost;
}

// Until the kernel has its final width, loops that are not plausible do not pull at all.
std::vector<double> Weights(const GraduatedKernel& kernel, const std::vector<double>& errors,
                            const std::vector<bool>& plausible) {
  std::vector<double> weights;
  for (size_t i = 0; i < errors.size(); ++i) {
    weights.push_back(plausible[i] || kernel.IsFinal() ? kernel.Weight(errors[i]) : 0.);
  }
  return weights;
}

// Solves with an ever narrower kernel, until weights and poses agree. Returns false on failure.
bool SolveRobustly(const proto::OptimizationOptions& options, const std::vector<bool>& plausible,
                   GraphProblem* problem, OptimizationReport* report) {
  GraduatedKernel kernel = MakeKernel(options);
  std::vector<double> errors = problem->SquaredLoopErrors();
  report->initial_cost = RobustCost(kernel, errors, problem);
  report->final_cost = report->initial_cost;
  report->converged = false;
  while (!report->converged && report->iterations < options.max_iterations()) {
    const bool was_final = kernel.IsFinal();
    kernel.Narrow(errors);
    const int steps = std::min(options.max_iterations() - report->iterations,
                               kernel.IsFinal() ? kLastSteps : kStepsPerWidth);
    const std::vector<double> weights = Weights(kernel, errors, plausible);
    const GraphProblem::Progress progress = problem->Solve(weights, steps);
    if (!progress.usable) return false;
    report->iterations += std::max(1, progress.iterations);
    errors = problem->SquaredLoopErrors();
    const double cost = RobustCost(kernel, errors, problem);
    report->converged =
        was_final && progress.converged && std::abs(cost - report->final_cost) <= kSettled * cost;
    report->final_cost = cost;
    report->num_rejected = static_cast<int>(std::count_if(
        weights.begin(), weights.end(), [](double weight) { return weight < kRejectedWeight; }));
  }
  return std::isfinite(report->final_cost);
}

}  // namespace

OptimizationReport OptimizeGraph(const proto::OptimizationOptions& options, Graph* graph) {
  OptimizationReport report;
  const GraphSelection selection = SelectFrom(*graph);
  report.num_loops = static_cast<int>(selection.loops.size());
  if (selection.loops.empty()) return report;
  std::map<int, OdometryChain> chains;
  for (const int id : selection.moving) {
    chains.try_emplace(id, options.odometry(), *graph, id);
  }
  GraphProblem problem(options, *graph, selection, chains);
  const std::vector<bool> plausible = FindPlausibleLoops(options, selection, chains);
  report.usable = SolveRobustly(options, plausible, &problem, &report);
  if (!report.usable) return report;
  problem.WriteTo(graph);
  report.correction_per_m = problem.SystematicErrors();
  return report;
}

}  // namespace cartographer::pose_graph
