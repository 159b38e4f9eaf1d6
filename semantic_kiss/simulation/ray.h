// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_RAY_H_
#define SEMANTIC_KISS_SIMULATION_RAY_H_

#include <Eigen/Core>

namespace semantic_kiss::simulation {

// A half-line: origin + t * direction, t >= 0. In the world if nothing else is said.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  // unit
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_RAY_H_
