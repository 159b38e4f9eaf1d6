// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PARABOLA_H_
#define CARTOGRAPHER_POSE_GRAPH_PARABOLA_H_

namespace cartographer::pose_graph {

// Where the parabola through three values at -1, 0 and 1 has its top; the middle one must not be
// smaller than the others.
constexpr double TopOfParabola(double left, double middle, double right) {
  const double curvature = left - 2. * middle + right;
  return curvature < 0. ? 0.5 * (left - right) / curvature : 0.;
}

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PARABOLA_H_
