// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_CONSTRAINT_INFORMATION_H_
#define CARTOGRAPHER_POSE_GRAPH_CONSTRAINT_INFORMATION_H_

#include "cartographer/submap/constraint.h"
#include "cartographer/transform/se3_jacobian.h"

namespace cartographer::pose_graph {

// The inverse covariance of a constraint's error, ordered as transform::Twist: in full if the
// constraint has it, else from its weights.
transform::Matrix6d InformationOf(const submap::Constraint& constraint);

// What is left of it if only x, y and heading count and nothing is said of height, roll and pitch:
// the inverse of that part of the covariance, in its place, and zeros. For poses that are level but
// for some degrees.
transform::Matrix6d PlanarInformation(const transform::Matrix6d& information);

// A W with W^T * W = information, for any symmetric positive semidefinite matrix (what rounding
// made negative counts as 0).
transform::Matrix6d SquareRoot(const transform::Matrix6d& information);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_CONSTRAINT_INFORMATION_H_
