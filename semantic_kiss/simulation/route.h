// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_ROUTE_H_
#define SEMANTIC_KISS_SIMULATION_ROUTE_H_

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"

namespace semantic_kiss::simulation {

// Position and heading in the plane of the world.
struct PlanarPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  double yaw = 0.;                                     // [rad], continuous along a route

  Eigen::Vector2d Forward() const;
  Eigen::Vector2d Left() const;
};

// A point of a line that the plane's streets follow.
struct StreetPoint {
  PlanarPose pose;
  bool highway = false;
};

// Where the car goes, seen from above: the pose of the car at every scan, and what the way says of
// the world around it. World frame: z up; recorded routes start at the origin heading along x, as
// the file does.
struct Route {
  std::vector<PlanarPose> poses;  // one a scan, at least two
  std::vector<bool> on_highway;   // one a scan
  // Heights of the lidar above the world's origin that a recording gives, one a scan, or none.
  std::vector<double> heights_m;
  // Centre lines of streets that are there but not driven; points about a metre apart.
  std::vector<std::vector<StreetPoint>> side_streets;
};

// Plans a synthetic route, or reads the recorded one. A function of its arguments alone (and of
// the file). Errors: the poses file cannot be read, has under two poses or does not move 2 m.
absl::StatusOr<Route> MakeRoute(const proto::RouteOptions& options, double scan_rate_hz,
                                uint64_t seed);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_ROUTE_H_
