// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/site.h"

#include <algorithm>
#include <cmath>

namespace semantic_kiss::simulation {
namespace {

constexpr double kNode_m = 0.5;

// Calls body(point), until it returns false, for points that cover the footprint as densely as the
// raster has nodes.
template <typename Body>
void ForEachPoint(const Footprint& footprint, const Body& body) {
  const int n = static_cast<int>(2. * footprint.half_length_m / (0.7 * kNode_m)) + 1;
  const int m = static_cast<int>(2. * footprint.half_width_m / (0.7 * kNode_m)) + 1;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) {
      if (!body(footprint.At(2. * i / n - 1., 2. * j / m - 1.))) return;
    }
  }
}

}  // namespace

Eigen::Vector2d Footprint::At(double u, double v) const {
  const Eigen::Vector2d forward(std::cos(yaw), std::sin(yaw));
  return centre + u * half_length_m * forward +
         v * half_width_m * Eigen::Vector2d(-forward.y(), forward.x());
}

Eigen::Vector2d Kerbside::At(double outside_m) const {
  return centre->pose.position +
         sign() * (centre->section.half_width_m + outside_m) * centre->pose.Left();
}

double Kerbside::TrafficYaw() const { return side == 1 ? Yaw() : Yaw() + M_PI; }

double Kerbside::InwardYaw() const { return Yaw() - sign() * 0.5 * M_PI; }

Site::Site(const proto::WorldOptions& world_options, uint64_t world_seed, int day,
           StreetMap* street_map)
    : options(world_options),
      seed(world_seed),
      epoch(day),
      streets(*street_map),
      taken_(street_map->bounds(), kNode_m, 0) {}

bool Site::IsFree(const Footprint& footprint, const Room& room) const {
  bool free = true;
  ForEachPoint(footprint, [&](const Eigen::Vector2d& point) {
    free = streets.bounds().contains(point) &&
           taken_.At(taken_.Node(point.x()), taken_.Node(point.y())) == 0 &&
           streets.Outside(point) >= room.outside_m && streets.Clearance(point) >= room.clearance_m;
    return free;
  });
  return free;
}

void Site::Occupy(const Footprint& footprint) {
  ForEachPoint(footprint, [&](const Eigen::Vector2d& point) {
    if (streets.bounds().contains(point)) {
      taken_.MutableAt(taken_.Node(point.x()), taken_.Node(point.y())) = 1;
    }
    return true;
  });
}

void Site::Add(const std::vector<Primitive>& pieces) {
  primitives.insert(primitives.end(), pieces.begin(), pieces.end());
}

Stand Site::StandAt(const Eigen::Vector2d& position, double yaw, uint32_t object) const {
  const double height_m = ground->Height(position);
  return {Eigen::Vector3d(position.x(), position.y(), height_m), yaw, object};
}

}  // namespace semantic_kiss::simulation
