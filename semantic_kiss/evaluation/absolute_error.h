// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_ABSOLUTE_ERROR_H_
#define SEMANTIC_KISS_EVALUATION_ABSOLUTE_ERROR_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/evaluation/vehicle_frame.h"

namespace semantic_kiss::evaluation {

// ATE: how far positions are off once the trajectories lie upon each other as well as they can.
struct AbsoluteError {
  double rmse_m = 0.;
  // Distance of each estimated position from the true one.
  std::vector<double> errors_m;
  // What those distances are the lengths of, a column each: aligned estimate - truth, along the
  // axes of the truth's world. For plots.
  Eigen::MatrixXd deviations;
};

// The fewest poses that have an ATE: with fewer there is nothing left to align upon.
inline constexpr int kMinPosesOfAbsoluteError = 3;

// ATE in space: the RMSE of positions after the rigid motion of the estimate (rotation and
// translation, no scale) that makes it smallest. Orientations play no part, nor does the choice of
// either world's frame.
//
// Here and below: sizes must be equal and all poses finite (CHECKed); absent under
// kMinPosesOfAbsoluteError poses.
// Source: Umeyama, PAMI 1991; Sturm et al., IROS 2012.
std::optional<AbsoluteError> ComputeAbsoluteError3d(
    const std::vector<cartographer::transform::Rigid3d>& ground_truth,
    const std::vector<cartographer::transform::Rigid3d>& estimate);

// ATE in the plane: positions are taken in the frame of their trajectory's first pose, heights are
// dropped there (camera: the x-z plane remains; lidar: the x-y plane), and what is left is aligned
// in the plane, by heading and two coordinates. In that order: aligning in space and dropping
// heights afterwards, as others do, gives another figure. Taking the first pose as the frame
// changes nothing for whole KITTI sequences (theirs is the identity) and makes excerpts comparable,
// whose truth starts somewhere on a slope. The rows of `deviations` are the two remaining axes of
// the truth's first pose, in ascending order.
std::optional<AbsoluteError> ComputeAbsoluteError2d(
    const std::vector<cartographer::transform::Rigid3d>& ground_truth,
    const std::vector<cartographer::transform::Rigid3d>& estimate, VehicleFrame frame);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_ABSOLUTE_ERROR_H_
