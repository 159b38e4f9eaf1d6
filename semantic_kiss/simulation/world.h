// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_WORLD_H_
#define SEMANTIC_KISS_SIMULATION_WORLD_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "semantic_kiss/simulation/ground.h"
#include "semantic_kiss/simulation/hills.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/primitive_grid.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"
#include "semantic_kiss/simulation/street_map.h"

namespace semantic_kiss::simulation {

// Everything that stands still on one day: a function of seed, route, options and epoch.
class World {
 public:
  World(const Route& route, const proto::WorldOptions& options, double mount_height_m,
        uint64_t seed, int epoch);

  const Hills& hills() const { return hills_; }
  const Ground& ground() const { return *ground_; }
  const StreetMap& streets() const { return streets_; }
  const std::vector<Primitive>& primitives() const { return primitives_; }
  const PrimitiveGrid& grid() const { return *grid_; }
  // What facades are shaped with.
  double wall_relief_m() const { return wall_relief_m_; }
  uint64_t seed() const { return seed_; }

 private:
  StreetMap streets_;
  Hills hills_;
  double wall_relief_m_;
  uint64_t seed_;
  std::unique_ptr<Ground> ground_;
  std::vector<Primitive> primitives_;
  std::unique_ptr<PrimitiveGrid> grid_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_WORLD_H_
