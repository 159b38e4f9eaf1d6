// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_CLOSURE_FIT_H_
#define CARTOGRAPHER_POSE_GRAPH_CLOSURE_FIT_H_

#include <Eigen/Core>

#include "cartographer/pose_graph/closure_target.h"
#include "cartographer/pose_graph/proto/verification_options.pb.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// How well a cloud at a pose fits a target. Judged are the points within the options' range and the
// target's box whose label is not of the ground.
struct ClosureFit {
  int num_judged = 0;
  double overlap = 0.;       // judged points with a target point nearby, of all judged
  double inlier_ratio = 0.;  // those with one of agreeing label close by, of the overlapping ones
  double rms_error_m = 0.;   // of the inliers
  // Inverse covariance of Log(target_from_node^-1 * truth), ordered as transform::Twist:
  //
  //   (  (P^-1 + sum_k J_k^T I_k J_k / n)^-1 + F  )^-1
  //
  // k: pairs close to each other, those on the ground included; J_k = R [I, -Hat(s_k)] moves the
  // point s_k of the cloud, R the rotation of target_from_node; I_k = LocalSurfaces::InformationAt;
  // n: pairs_per_measurement; P, F: the prior's and the floor's variances.
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  // Largest standard deviation along any direction and about any axis, by that.
  double max_sigma_m = 0.;
  double max_sigma_rad = 0.;
};

// `cloud` in the node's (sensor's) frame, finite; may be empty. One pass over the points.
ClosureFit JudgeFit(const sensor::LabeledPointCloud& cloud,
                    const transform::Rigid3d& target_from_node, const ClosureTarget& target,
                    const proto::VerificationOptions& options);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_CLOSURE_FIT_H_
