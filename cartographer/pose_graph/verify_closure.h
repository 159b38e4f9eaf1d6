// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_VERIFY_CLOSURE_H_
#define CARTOGRAPHER_POSE_GRAPH_VERIFY_CLOSURE_H_

#include <Eigen/Core>
#include <optional>

#include "absl/strings/string_view.h"
#include "cartographer/pose_graph/closure_target.h"
#include "cartographer/pose_graph/proto/verification_options.pb.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// What came of a candidate; the first reason in this order counts.
enum class Verdict {
  kAccepted,
  kIcpFailed,        // no registration: too few points, no pairs, pairs on a line
  kTooFewPoints,     // too little to judge by where both were
  kLowOverlap,       // much of what the node saw is not there
  kLowInlierRatio,   // what is there has another shape or other labels
  kLargeError,       // nearly fits, but not well enough for the same place
  kLargeCorrection,  // registration contradicts the match in the plane
  kHeightMismatch,   // the grounds do not meet
  kDegenerate        // some motion of the node would not show
};
inline constexpr int kNumVerdicts = 9;

// "accepted", "low_overlap", ...: the words of logs and reports.
absl::string_view VerdictName(Verdict verdict);

struct ClosureReport {
  Verdict verdict = Verdict::kIcpFailed;
  // As registered; with kIcpFailed, the guess.
  transform::Rigid3d submap_from_node;
  // closure_fit.h; all of it at submap_from_node, 0 with kIcpFailed.
  double overlap = 0.;
  double inlier_ratio = 0.;
  double rms_error_m = 0.;
  double max_sigma_m = 0.;
  double max_sigma_deg = 0.;
  // From the guess to submap_from_node: in the plane, and the angle in space.
  double correction_m = 0.;
  double correction_deg = 0.;
  // How far the guess was lifted to put the node's ground on the submap's, and how far they were
  // still apart after registration; nullopt where too little ground was seen.
  std::optional<double> height_offset_m;
  std::optional<double> height_mismatch_m;
  // Inverse covariance of Log(submap_from_node^-1 * truth), ordered as transform::Twist: what
  // submap::Constraint takes.
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();

  bool accepted() const { return verdict == Verdict::kAccepted; }
};

// Decides whether a match in the plane is a closure, and refines it to all six degrees of freedom:
// lifts the node's ground onto the submap's, registers its cloud with the submap's points (the
// odometry's own ICP, from coarse to fine), and asks how well it then fits.
//
//   cloud                    the node's, in its sensor's frame [m], finite; may be empty
//   submap_from_node_guess   x, y and yaw of the match; roll, pitch and height as the odometry has
//                            them. Height is only needed where no ground was seen.
//
// Deterministic on any number of threads; different candidates may be verified in parallel.
ClosureReport VerifyClosure(const sensor::LabeledPointCloud& cloud,
                            const transform::Rigid3d& submap_from_node_guess,
                            const ClosureTarget& target, const proto::VerificationOptions& options);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_VERIFY_CLOSURE_H_
