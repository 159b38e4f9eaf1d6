// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_WORLD_H_
#define SEMANTIC_KISS_SIMULATION_WORLD_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "semantic_kiss/simulation/ground.h"
#include "semantic_kiss/simulation/hills.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/primitive_grid.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/ray.h"
#include "semantic_kiss/simulation/route.h"
#include "semantic_kiss/simulation/street_map.h"

namespace semantic_kiss::simulation {

// Object number of the ground in hits.
inline constexpr uint32_t kGroundObject = 0;

// What a ray meets.
struct Hit {
  double range_m = 0.;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // outward
  Material material;
  uint32_t object = kGroundObject;
  Texture texture = Texture::kSolid;
  // Index into World::primitives(), or of the moving pieces; -1: the ground.
  int primitive = -1;
  bool moving = false;
};

// Everything that stands still on one day: a function of seed, route, options and epoch.
class World {
 public:
  World(const Route& route, const proto::WorldOptions& options, double mount_height_m,
        uint64_t seed, int epoch);

  // The first thing within `limit_m` that stops the ray, if any. `ray_key` decides chances: how
  // deep leaves are entered, whether a fence or a pane lets the ray pass.
  std::optional<Hit> Cast(const Ray& ray, double limit_m, uint64_t ray_key) const;

  const Hills& hills() const { return hills_; }
  const Ground& ground() const { return *ground_; }
  const StreetMap& streets() const { return streets_; }
  const std::vector<Primitive>& primitives() const { return primitives_; }

 private:
  StreetMap streets_;
  Hills hills_;
  double wall_relief_m_;
  uint64_t seed_;
  std::unique_ptr<Ground> ground_;
  std::vector<Primitive> primitives_;
  std::unique_ptr<PrimitiveGrid> grid_;
};

// Where a ray stops in one primitive, following its texture; nullopt if it passes. The rays of one
// key always fare alike with the same object.
std::optional<double> StopIn(const Primitive& primitive, const Stretch& stretch, uint64_t ray_key);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_WORLD_H_
