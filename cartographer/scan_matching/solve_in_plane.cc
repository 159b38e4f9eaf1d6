// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/solve_in_plane.h"

#include <cmath>

#include "ceres/cost_function.h"
#include "ceres/problem.h"
#include "ceres/solver.h"

namespace cartographer::scan_matching {
namespace {

class Cost : public ceres::CostFunction {
 public:
  explicit Cost(const PlanarResiduals& residuals) : residuals_(residuals) {
    set_num_residuals(residuals.size());
    mutable_parameter_block_sizes()->push_back(3);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double* const pose = parameters[0];
    residuals_.Evaluate({{pose[0], pose[1]}, pose[2]}, residuals,
                        jacobians == nullptr ? nullptr : jacobians[0]);
    return true;
  }

 private:
  const PlanarResiduals& residuals_;
};

}  // namespace

PlanarSolution SolveInPlane(const PlanarResiduals& residuals, const PlanarPose& guess,
                            int max_iterations, double function_tolerance) {
  double pose[] = {guess.translation.x(), guess.translation.y(), guess.yaw_rad};
  ceres::Problem problem;
  problem.AddResidualBlock(new Cost(residuals), nullptr, pose);
  ceres::Solver::Options options;
  options.max_num_iterations = max_iterations;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.function_tolerance = function_tolerance;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {{{pose[0], pose[1]}, std::remainder(pose[2], 2. * M_PI)},
          summary.IsSolutionUsable(),
          summary.initial_cost,
          summary.final_cost};
}

}  // namespace cartographer::scan_matching
