// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_NORMAL_EQUATIONS_H_
#define CARTOGRAPHER_REGISTRATION_NORMAL_EQUATIONS_H_

#include <Eigen/Core>

#include "cartographer/transform/se3.h"

namespace cartographer::registration {

// The Geman-McClure weight of a residual: (sigma / (sigma + r^2))^2, 1 at r = 0 (KISS-ICP, eq. 8:
// sigma enters unsquared, as in its code).
inline double GemanMcClureWeight(double squared_residual, double kernel_scale) {
  const double ratio = kernel_scale / (kernel_scale + squared_residual);
  return ratio * ratio;
}

// The normal equations of weighted point-to-point ICP,
//
//   minimize over dx:  sum_i w_i |Exp(dx) s_i - q_i|^2,
//
// linearized at dx = 0, where the residual is r = s - q and its Jacobian [I, -Hat(s)]. Because of
// that form a handful of sums over the pairs is all there is:
//
//   H = sum w [ I       -Hat(s)  ]      g = sum w [ r     ]
//             [ Hat(s)  -Hat(s)^2]                [ s x r ]
//
// Sums are plain additions, so adding the parts of several chunks in a fixed order gives the same
// bits whatever the number of threads.
class NormalEquations {
 public:
  // A pair: source point and target point in the same frame [m], and its weight (>= 0).
  void AddPair(const Eigen::Vector3d& source, const Eigen::Vector3d& target, double weight) {
    const Eigen::Vector3d residual = source - target;
    const Eigen::Vector3d weighted = weight * source;
    weight_ += weight;
    first_moment_ += weighted;
    second_moment_.noalias() += weighted * source.transpose();
    residual_ += weight * residual;
    torque_ += weighted.cross(residual);
    squared_error_ += residual.squaredNorm();
    ++num_pairs_;
  }

  void Add(const NormalEquations& other);

  // H, the sum of weighted J^T J; rows and columns ordered as transform::Twist.
  Eigen::Matrix<double, 6, 6> Hessian() const;
  // g, the sum of weighted J^T r.
  Eigen::Matrix<double, 6, 1> Gradient() const;
  // The Gauss-Newton step -H^-1 g. Requires that Degenerate() is false for some lever arm > 0.
  transform::Twist Solve() const;

  // The weighted root mean square distance [m] of the source points from that axis about which it
  // is the smallest; 0 if all points lie on a line or have no weight.
  double MinLeverArm() const;

  double weight() const { return weight_; }
  int num_pairs() const { return num_pairs_; }
  // Unweighted root mean square residual [m]; 0 without pairs.
  double RootMeanSquareError() const;

 private:
  double weight_ = 0.;
  Eigen::Vector3d first_moment_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_moment_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d residual_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_ = Eigen::Vector3d::Zero();
  double squared_error_ = 0.;
  int num_pairs_ = 0;
};

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_NORMAL_EQUATIONS_H_
