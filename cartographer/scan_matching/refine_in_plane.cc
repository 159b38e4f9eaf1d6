// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/refine_in_plane.h"

#include <cmath>

#include "cartographer/scan_matching/smooth_agreement.h"
#include "glog/logging.h"

namespace cartographer::scan_matching {
namespace {

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
  const PlanarSolution solution =
      SolveInPlane(residuals, guess, options.max_iterations(), options.function_tolerance());
  result.refined = solution.usable && IsNear(solution.pose, guess, options);
  if (result.refined) result.submap_from_node = solution.pose;
  result.agreement = 1. - 2. * (result.refined ? solution.final_cost : solution.initial_cost);
  return result;
}

}  // namespace cartographer::scan_matching
