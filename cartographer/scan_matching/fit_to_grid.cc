// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/fit_to_grid.h"

#include <cmath>

#include "glog/logging.h"

namespace cartographer::scan_matching {

GridFitResiduals::GridFitResiduals(const submap::ProbabilityGrid& grid,
                                   const std::vector<Eigen::Vector2d>& points,
                                   const PlanarPose& grid_from_expected,
                                   const proto::GridFitOptions& options)
    : surface_(grid), points_(points), expected_(grid_from_expected), options_(options) {
  CHECK(!points.empty());
}

void GridFitResiduals::Evaluate(const PlanarPose& grid_from_scan, double* residuals,
                                double* jacobian) const {
  const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(grid_from_scan.yaw_rad).toRotationMatrix();
  const double scale =
      options_.occupied_space_weight() / std::sqrt(static_cast<double>(points_.size()));
  for (const Eigen::Vector2d& point : points_) {
    const Eigen::Vector2d arm = rotation * point;
    const auto sample = surface_.At(arm + grid_from_scan.translation);
    *residuals++ = scale * (1. - sample.value);
    if (jacobian == nullptr) continue;
    *jacobian++ = -scale * sample.gradient.x();
    *jacobian++ = -scale * sample.gradient.y();
    *jacobian++ = -scale * (sample.gradient.y() * arm.x() - sample.gradient.x() * arm.y());
  }
  const Eigen::Vector3d weights(options_.translation_weight_per_m(),
                                options_.translation_weight_per_m(),
                                options_.rotation_weight_per_rad());
  Eigen::Vector3d moved;
  moved << grid_from_scan.translation - expected_.translation,
      std::remainder(grid_from_scan.yaw_rad - expected_.yaw_rad, 2. * M_PI);
  Eigen::Map<Eigen::Vector3d> last_residuals(residuals);
  last_residuals = weights.cwiseProduct(moved);
  if (jacobian == nullptr) return;
  Eigen::Map<Eigen::Matrix3d> last_rows(jacobian);
  last_rows = weights.asDiagonal();
}

GridFit FitToGrid(const submap::ProbabilityGrid& grid, const std::vector<Eigen::Vector2d>& points,
                  const PlanarPose& grid_from_expected, const PlanarPose& grid_from_guess,
                  const proto::GridFitOptions& options) {
  GridFit fit;
  fit.grid_from_scan = grid_from_guess;
  if (points.empty()) return fit;
  const GridFitResiduals residuals(grid, points, grid_from_expected, options);
  const PlanarSolution solution = SolveInPlane(residuals, grid_from_guess, options.max_iterations(),
                                               options.function_tolerance());
  fit.usable = solution.usable;
  if (fit.usable) fit.grid_from_scan = solution.pose;
  const ProbabilitySurface surface(grid);
  const Eigen::Rotation2Dd rotation(fit.grid_from_scan.yaw_rad);
  for (const Eigen::Vector2d& point : points) {
    fit.score += surface.At(rotation * point + fit.grid_from_scan.translation).value;
  }
  fit.score /= static_cast<double>(points.size());
  return fit;
}

}  // namespace cartographer::scan_matching
