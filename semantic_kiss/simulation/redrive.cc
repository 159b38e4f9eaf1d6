// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/redrive.h"

#include <algorithm>

namespace semantic_kiss::simulation {
namespace {

PlanarPose PoseBetween(const PlanarPose& a, const PlanarPose& b, double share) {
  return {a.position + share * (b.position - a.position), a.yaw + share * (b.yaw - a.yaw)};
}

}  // namespace

Route Redrive(const Route& route, double lane_offset_m, double speed_factor) {
  Route driven;
  driven.side_streets = route.side_streets;
  const size_t last = route.poses.size() - 1;
  for (size_t i = 0;; ++i) {
    const double at = static_cast<double>(i) * speed_factor;
    const auto before = static_cast<size_t>(at);
    if (before > last || (before == last && at > static_cast<double>(last))) break;
    const size_t after = std::min(before + 1, last);
    const double share = at - static_cast<double>(before);
    PlanarPose pose = PoseBetween(route.poses[before], route.poses[after], share);
    pose.position += lane_offset_m * pose.Left();
    driven.poses.push_back(pose);
    driven.on_highway.push_back(route.on_highway[before]);
    if (!route.heights_m.empty()) {
      driven.heights_m.push_back(route.heights_m[before] +
                                 share * (route.heights_m[after] - route.heights_m[before]));
    }
  }
  return driven;
}

}  // namespace semantic_kiss::simulation
