// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SOLVE_IN_PLANE_H_
#define CARTOGRAPHER_SCAN_MATCHING_SOLVE_IN_PLANE_H_

#include "cartographer/scan_matching/planar_pose.h"

namespace cartographer::scan_matching {

// A least-squares problem whose only unknown is a pose in the plane.
class PlanarResiduals {
 public:
  virtual ~PlanarResiduals() = default;
  virtual int size() const = 0;
  // size() residuals at a pose and, unless `jacobian` is null, their derivatives by (x, y, yaw),
  // residual by residual.
  virtual void Evaluate(const PlanarPose& pose, double* residuals, double* jacobian) const = 0;
};

struct PlanarSolution {
  PlanarPose pose;  // yaw in [-pi, pi]
  bool usable = false;
  double initial_cost = 0.;  // half the sum of squared residuals
  double final_cost = 0.;
};

// Where half the sum of squared residuals has its minimum next to `guess`. Ends after
// `max_iterations`, or as soon as a step changes the sum by a share of less than
// `function_tolerance`.
PlanarSolution SolveInPlane(const PlanarResiduals& residuals, const PlanarPose& guess,
                            int max_iterations, double function_tolerance);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SOLVE_IN_PLANE_H_
