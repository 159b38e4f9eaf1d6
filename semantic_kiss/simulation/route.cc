// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/route.h"

#include <cmath>

#include "semantic_kiss/simulation/recorded_route.h"
#include "semantic_kiss/simulation/synthetic_routes.h"

namespace semantic_kiss::simulation {

Eigen::Vector2d PlanarPose::Forward() const {
  return Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
}

Eigen::Vector2d PlanarPose::Left() const { return Eigen::Vector2d(-std::sin(yaw), std::cos(yaw)); }

absl::StatusOr<Route> MakeRoute(const proto::RouteOptions& options, double scan_rate_hz,
                                uint64_t seed) {
  if (options.kind() == "recorded") return ReadRecordedRoute(options, scan_rate_hz, seed);
  if (options.kind() == "highway") return MakeHighwayRoute(options, scan_rate_hz, seed);
  if (options.kind() == "loop") return MakeLoopRoute(options, scan_rate_hz, seed);
  return MakeCityRoute(options, scan_rate_hz, seed);
}

}  // namespace semantic_kiss::simulation
