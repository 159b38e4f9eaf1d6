// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/refine_in_plane.h"

#include <cmath>

#include "cartographer/scan_matching/smooth_agreement.h"
#include "ceres/cost_function.h"
#include "ceres/problem.h"
#include "ceres/solver.h"
#include "glog/logging.h"

namespace cartographer::scan_matching {
namespace {

class Cost : public ceres::CostFunction {
 public:
  explicit Cost(const AgreementResiduals& residuals) : residuals_(residuals) {
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
  const AgreementResiduals& residuals_;
};

bool IsNear(const PlanarPose& pose, const PlanarPose& guess,
            const proto::RefinementOptions& options) {
  const double turned_rad = std::remainder(pose.yaw_rad - guess.yaw_rad, 2. * M_PI);
  return (pose.translation - guess.translation).norm() <= options.max_translation_m() &&
         std::abs(turned_rad) <= options.max_rotation_deg() * M_PI / 180.;
}

}  // namespace

AgreementResiduals::AgreementResiduals(const SubmapMatcher& matcher, const MatchingScan& scan)
    : matcher_(matcher), scan_(scan) {
  CHECK(!scan.empty());
}

void AgreementResiduals::Evaluate(const PlanarPose& submap_from_node, double* residuals,
                                  double* jacobian) const {
  const SmoothAgreement agreement(matcher_.pyramid(), matcher_.resolution_m());
  const double cosine = std::cos(submap_from_node.yaw_rad);
  const double sine = std::sin(submap_from_node.yaw_rad);
  const double total_weight = static_cast<double>(scan_.total_weight());
  scan_.ForEachPoint([&](int layer, const Eigen::Vector2d& point, int weight) {
    const Eigen::Vector2d arm(cosine * point.x() - sine * point.y(),
                              sine * point.x() + cosine * point.y());
    const auto sample = agreement.At(layer, arm + submap_from_node.translation);
    const double scale = std::sqrt(weight / total_weight);
    *residuals++ = scale * (1. - sample.value);
    if (jacobian == nullptr) return;
    *jacobian++ = -scale * sample.gradient.x();
    *jacobian++ = -scale * sample.gradient.y();
    *jacobian++ = -scale * (sample.gradient.y() * arm.x() - sample.gradient.x() * arm.y());
  });
}

PlanarRefinement RefineInPlane(const SubmapMatcher& matcher, const MatchingScan& scan,
                               const PlanarPose& guess, const proto::RefinementOptions& options) {
  PlanarRefinement result;
  result.submap_from_node = guess;
  if (scan.empty()) return result;
  const AgreementResiduals residuals(matcher, scan);
  double pose[] = {guess.translation.x(), guess.translation.y(), guess.yaw_rad};
  ceres::Problem problem;
  problem.AddResidualBlock(new Cost(residuals), nullptr, pose);
  ceres::Solver::Options solver_options;
  solver_options.max_num_iterations = options.max_iterations();
  solver_options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  solver_options.function_tolerance = options.function_tolerance();
  solver_options.num_threads = 1;
  solver_options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options, &problem, &summary);

  const PlanarPose refined{{pose[0], pose[1]}, std::remainder(pose[2], 2. * M_PI)};
  result.refined = summary.IsSolutionUsable() && IsNear(refined, guess, options);
  if (result.refined) result.submap_from_node = refined;
  result.agreement = 1. - 2. * (result.refined ? summary.final_cost : summary.initial_cost);
  return result;
}

}  // namespace cartographer::scan_matching
