// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/world.h"

#include <cmath>

#include "semantic_kiss/simulation/facade.h"
#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/world_builder.h"

namespace semantic_kiss::simulation {

std::optional<double> StopIn(const Primitive& primitive, const Stretch& stretch, uint64_t ray_key) {
  switch (primitive.texture) {
    case Texture::kCloud: {
      const double chance = ToUniform(HashKey({ray_key, primitive.object}));
      const double depth_m = -std::log(1. - chance) / primitive.density;
      const double t = std::max(stretch.near, 0.) + depth_m;
      if (t > stretch.far) return std::nullopt;
      return t;
    }
    case Texture::kPorous:
      if (ToUniform(HashKey({ray_key, primitive.object})) > primitive.density) return std::nullopt;
      break;
    default:
      break;
  }
  if (stretch.near < 0.) return std::nullopt;
  return stretch.near;
}

World::World(const Route& route, const proto::WorldOptions& options, double mount_height_m,
             uint64_t seed, int epoch)
    : streets_(route, options.margin_m(), seed),
      hills_(route, streets_.bounds(), options, mount_height_m, seed),
      wall_relief_m_(options.wall_relief_m()),
      seed_(seed) {
  WorldBuilder builder(options, seed, epoch, &streets_);
  builder.PlanLots();
  ground_ = std::make_unique<Ground>(streets_, hills_, options, seed);
  primitives_ = builder.Build(*ground_);
  grid_ = std::make_unique<PrimitiveGrid>(primitives_);
}

std::optional<Hit> World::Cast(const Ray& ray, double limit_m, uint64_t ray_key) const {
  std::optional<Hit> hit;
  const std::optional<double> ground = ground_->Intersect(ray, limit_m);
  int nearest = -1;
  Eigen::Vector3d normal;
  double best_m = ground.value_or(limit_m);
  grid_->Walk(ray, best_m, [&](uint32_t index, double limit) {
    const Primitive& primitive = primitives_[index];
    const std::optional<Stretch> stretch = Intersect(primitive, ray);
    if (!stretch || stretch->near > limit) return limit;
    const std::optional<double> t = StopIn(primitive, *stretch, ray_key);
    if (!t || *t >= limit) return limit;
    nearest = static_cast<int>(index);
    normal = stretch->normal;
    return best_m = *t;
  });
  if (nearest >= 0) {
    const Primitive& primitive = primitives_[nearest];
    hit = Hit{best_m, normal, primitive.material, primitive.object, primitive.texture, nearest};
    if (primitive.texture == Texture::kFacade) {
      ShapeFacade(primitive, ray, wall_relief_m_, seed_, &*hit);
    }
  } else if (ground) {
    const Eigen::Vector2d point = (ray.origin + *ground * ray.direction).head<2>();
    hit = Hit{*ground, ground_->Normal(point), ground_->MaterialAt(point)};
  }
  return hit;
}

}  // namespace semantic_kiss::simulation
