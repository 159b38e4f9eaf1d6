// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_FIT_TO_GRID_H_
#define CARTOGRAPHER_SCAN_MATCHING_FIT_TO_GRID_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/probability_surface.h"
#include "cartographer/scan_matching/proto/planar_matching_options.pb.h"
#include "cartographer/scan_matching/solve_in_plane.h"
#include "cartographer/submap/probability_grid.h"

namespace cartographer::scan_matching {

// What the fit minimizes half the squared norm of:
//
//   w_o / sqrt(N) * (1 - P(R s_i + t))     for each of the N points s_i of the scan,
//   w_t * (t - t_0)                        two of them,
//   w_r * (yaw - yaw_0),
//
// P the interpolated probability of being occupied, t_0 and yaw_0 the expected pose, from which a
// scan that shows nothing in some direction should not move away.
// Source: Hess et al., "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016, section IV-C; the
// terms of the expected pose as in Cartographer's code.
class GridFitResiduals : public PlanarResiduals {
 public:
  // Keeps references: all must outlive this. There must be points (CHECKed).
  GridFitResiduals(const submap::ProbabilityGrid& grid, const std::vector<Eigen::Vector2d>& points,
                   const PlanarPose& grid_from_expected, const proto::GridFitOptions& options);

  int size() const override { return static_cast<int>(points_.size()) + 3; }
  void Evaluate(const PlanarPose& grid_from_scan, double* residuals,
                double* jacobian) const override;

 private:
  const ProbabilitySurface surface_;
  const std::vector<Eigen::Vector2d>& points_;
  const PlanarPose expected_;
  const proto::GridFitOptions& options_;
};

struct GridFit {
  PlanarPose grid_from_scan;  // the guess, if there is no usable solution
  bool usable = false;
  // Mean of P at the points.
  double score = 0.;
};

// Finds the minimum next to a guess.
//   points              of the scan, in its frame, in the plane [m]; none: the guess, not usable
//   grid_from_expected  the expected pose
//   grid_from_guess     where to begin: that, or what a search found
GridFit FitToGrid(const submap::ProbabilityGrid& grid, const std::vector<Eigen::Vector2d>& points,
                  const PlanarPose& grid_from_expected, const PlanarPose& grid_from_guess,
                  const proto::GridFitOptions& options);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_FIT_TO_GRID_H_
