// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_ODOMETRY_UNCERTAINTY_H_
#define CARTOGRAPHER_POSE_GRAPH_ODOMETRY_UNCERTAINTY_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/pose_graph/odometry_chain.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"

namespace cartographer::pose_graph {

// Variances of the error of a relative pose, alike in all directions.
struct PoseVariance {
  double translation_m2 = 0.;
  double rotation_rad2 = 0.;
};

inline PoseVariance operator+(const PoseVariance& a, const PoseVariance& b) {
  return {a.translation_m2 + b.translation_m2, a.rotation_rad2 + b.rotation_rad2};
}

// How wrong the odometry may be between any two nodes of a trajectory, in constant time: every step
// on the way adds its own error and turns all that comes after it, with a lever as long as the way
// from there to the end as the crow flies. Of each kind of error the largest axis counts for all.
class OdometryUncertainty {
 public:
  OdometryUncertainty(const proto::OdometryErrorOptions& options, const OdometryChain& chain);

  // In any order.
  PoseVariance Between(int a, int b) const;

 private:
  const transform::Twist random_, systematic_;
  std::vector<Eigen::Vector3d> positions_;
  // Sums over the steps up to a node: of their lengths l, of l * x, and of l * |x|^2.
  std::vector<double> length_m_;
  std::vector<Eigen::Vector3d> first_moment_;
  std::vector<double> second_moment_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_ODOMETRY_UNCERTAINTY_H_
