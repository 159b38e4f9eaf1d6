// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_HILLS_H_
#define SEMANTIC_KISS_SIMULATION_HILLS_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// The large forms of the ground: one height for every point of the plane, the same at every visit,
// with continuous slopes (a quadratic B-spline over a lattice).
class Hills {
 public:
  // Random hills for routes without heights, else the smooth field that passes near the route's
  // heights less `mount_height_m`; where the route contradicts itself at a revisit, the mean.
  Hills(const Route& route, const Eigen::AlignedBox2d& bounds, const proto::WorldOptions& options,
        double mount_height_m, uint64_t seed);

  // [m]; beyond the bounds the rim's heights go on.
  double Height(const Eigen::Vector2d& position) const;

 private:
  void FitRoute(const Route& route, double mount_height_m);

  Eigen::Vector2d origin_;
  int columns_, rows_;
  std::vector<double> heights_m_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_HILLS_H_
