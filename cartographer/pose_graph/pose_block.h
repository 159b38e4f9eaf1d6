// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_POSE_BLOCK_H_
#define CARTOGRAPHER_POSE_GRAPH_POSE_BLOCK_H_

#include <array>

#include "cartographer/transform/rigid_transform.h"
#include "ceres/manifold.h"

namespace cartographer::pose_graph {

// A pose as a parameter block of Ceres: translation, then the quaternion as x, y, z, w.
constexpr int kPoseBlockSize = 7;
using PoseBlock = std::array<double, kPoseBlockSize>;

PoseBlock ToBlock(const transform::Rigid3d& pose);
transform::Rigid3d FromBlock(const double* block);

// How steps are taken, and with respect to what the Jacobians of our cost functions are.
//
// A cost function gives, as the first six of the seven columns for a pose T, its derivatives by the
// twist delta of T * Exp(delta), a perturbation from the right; the seventh is 0. This manifold's
// PlusJacobian passes those six on. So derivatives by the seven numbers of a block, of which nobody
// has any use, are never formed.
class PoseManifold : public ceres::Manifold {
 public:
  int AmbientSize() const override { return kPoseBlockSize; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

// As above, for poses that move only in the plane: by (x, y) and a turn about the z axis through
// the pose, both in the frame of the map. Height, roll and pitch stay.
class PlanarPoseManifold : public ceres::Manifold {
 public:
  int AmbientSize() const override { return kPoseBlockSize; }
  int TangentSize() const override { return 3; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

// Where `pose` gets by moving in the plane to the position and heading of `target`: height, roll
// and pitch are those of `pose`, the height to the bit.
transform::Rigid3d MovedInPlane(const transform::Rigid3d& pose, const transform::Rigid3d& target);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_POSE_BLOCK_H_
