// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/world.h"

#include "semantic_kiss/simulation/world_builder.h"

namespace semantic_kiss::simulation {

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

}  // namespace semantic_kiss::simulation
