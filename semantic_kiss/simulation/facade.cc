// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/facade.h"

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

struct Facade {
  double storey_m, bay_m, window_width_m, window_height_m, sill_m, niche_m;
};

Facade FacadeOf(uint64_t key) {
  Random random(key);
  return {random.Uniform(2.7, 3.3), random.Uniform(1.9, 3.4), random.Uniform(0.8, 1.4),
          random.Uniform(1.1, 1.7), random.Uniform(0.7, 1.0), random.Uniform(0.08, 0.24)};
}

bool InWindow(const Facade& facade, double along_m, double height_m, double wall_height_m) {
  const double storey = std::floor(height_m / facade.storey_m);
  if (storey < 0. || (storey + 1.) * facade.storey_m > wall_height_m) return false;
  const double v = height_m - storey * facade.storey_m - facade.sill_m;
  const double u = std::abs(std::remainder(along_m, facade.bay_m));
  return v > 0. && v < facade.window_height_m && u < 0.5 * facade.window_width_m;
}

}  // namespace

void ShapeFacade(const Primitive& wall, const Ray& ray, double relief_m, uint64_t seed, Hit* hit) {
  if (std::abs(hit->normal.z()) > 0.5) return;
  const Eigen::Vector3d point =
      wall.ToLocal(ray.origin + hit->range_m * ray.direction - wall.centre);
  const Eigen::Vector3d normal = wall.ToLocal(hit->normal);
  const bool gable_side = std::abs(normal.x()) > std::abs(normal.y());
  const double along_m = gable_side ? point.y() : point.x();
  const double height_m = point.z() + wall.half.z() - 0.3;
  const uint64_t key = HashKey({seed, static_cast<uint64_t>(Purpose::kSurface), wall.object});
  const int side = (gable_side ? 0 : 2) + ((gable_side ? normal.x() : normal.y()) > 0. ? 1 : 0);

  const double swell = Roughness(key + side, along_m / 2.6, height_m / 2.6);
  const Facade facade = FacadeOf(key);
  const bool window = InWindow(facade, along_m, height_m, 2. * wall.half.z());
  const double depth_m = relief_m * std::clamp(swell, -3., 3.) + (window ? facade.niche_m : 0.);
  const double further_m = depth_m / std::max(0.2, -hit->normal.dot(ray.direction));
  // A grazing ray must not slip off the wall's end into the air.
  const Eigen::Vector3d moved = point + further_m * wall.ToLocal(ray.direction);
  const int axis = gable_side ? 1 : 0;
  if (std::abs(moved[axis]) > wall.half[axis]) return;
  if (window) hit->material = material::kGlass;
  hit->range_m = std::max(0.05, hit->range_m + further_m);
}

}  // namespace semantic_kiss::simulation
