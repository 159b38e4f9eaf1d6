// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_RELATIVE_POSE_COST_H_
#define CARTOGRAPHER_POSE_GRAPH_RELATIVE_POSE_COST_H_

#include "cartographer/pose_graph/odometry_chain.h"
#include "cartographer/pose_graph/pose_block.h"
#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"
#include "cartographer/transform/se3_jacobian.h"
#include "ceres/sized_cost_function.h"

namespace cartographer::pose_graph {

// The cost functions of the pose graph: what two poses, map_from_a and map_from_b, contradict a
// measurement of one in the frame of the other, in units of its standard deviation. Derivatives are
// exact, and by the twists that pose_block.h tells of.

// sqrt(weight) * W * Log(a_from_b^-1 * map_from_a^-1 * map_from_b).
class RelativePoseCost : public ceres::SizedCostFunction<6, kPoseBlockSize, kPoseBlockSize> {
 public:
  // `weight` is read at each evaluation; it is >= 0 and must outlive the cost.
  RelativePoseCost(const transform::Rigid3d& a_from_b, const transform::Matrix6d& sqrt_information,
                   const double* weight);
  bool Evaluate(const double* const* poses, double* residuals, double** jacobians) const override;

 private:
  const transform::Rigid3d b_from_a_;
  const transform::Matrix6d sqrt_information_;
  const double* const weight_;
};

// W * Log((odometry * Exp(drift * S * u))^-1 * map_from_start^-1 * map_from_end), where W is from
// the covariance of the segment. The third block is u, the systematic error of the odometry in
// units of its expected size, S = diag(systematic_sigmas): twist_per_m = S * u.
class OdometryCost : public ceres::SizedCostFunction<6, kPoseBlockSize, kPoseBlockSize, 6> {
 public:
  OdometryCost(const OdometrySegment& segment, const transform::Twist& systematic_sigmas);
  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const transform::Rigid3d end_from_start_;
  const transform::Matrix6d drift_;  // drift * S
  transform::Matrix6d sqrt_information_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_RELATIVE_POSE_COST_H_
