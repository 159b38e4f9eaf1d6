// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_PATH_H_
#define SEMANTIC_KISS_SIMULATION_PATH_H_

#include <vector>

#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// A line in the plane sampled every kPathStep_m of its length, with its curvature's radius.
struct PathPoint {
  PlanarPose pose;
  double radius_m = 1e9;  // of the bend, > 0
};
inline constexpr double kPathStep_m = 0.25;

// A corner of a polygonal line and the radius by which it is rounded, where there is room for it.
struct Corner {
  Eigen::Vector2d position;
  double radius_m = 10.;
};

// The line through all `corners`, its corners rounded by arcs; at least two corners, neighbours
// not at the same place.
std::vector<PathPoint> RoundedPath(const std::vector<Corner>& corners);

// `pose` at every multiple of 1/rate_hz while the path is driven as fast as the limits allow,
// starting at the cruising speed.
struct SpeedLimits {
  double cruise_m_per_s = 10.;
  double lateral_m_per_s2 = 2.;       // in bends
  double longitudinal_m_per_s2 = 1.;  // speeding up and braking
};
std::vector<PlanarPose> DrivePath(const std::vector<PathPoint>& path, const SpeedLimits& limits,
                                  double rate_hz);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_PATH_H_
