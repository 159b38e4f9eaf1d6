// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_WORLD_BUILDER_H_
#define SEMANTIC_KISS_SIMULATION_WORLD_BUILDER_H_

#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/ground.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/site.h"
#include "semantic_kiss/simulation/street_map.h"

namespace semantic_kiss::simulation {

// Builds the town along the streets, in two steps: car parks are laid out before the ground gets
// its shape, everything else stands on it.
class WorldBuilder {
 public:
  // `streets` must outlive the builder.
  WorldBuilder(const proto::WorldOptions& options, uint64_t seed, int epoch, StreetMap* streets);

  // Marks car parks in the street map.
  void PlanLots();

  // All that stands on `ground`; call once, after PlanLots().
  std::vector<Primitive> Build(const Ground& ground);

 private:
  Site site_;
  std::vector<Footprint> lots_;
};

// The trades, in the order in which they come: those who come later find less room.
void PlaceKerbsideVehicles(Site* site);
void PlaceLotVehicles(const std::vector<Footprint>& lots, Site* site);
void PlaceStreetFurniture(Site* site);
void PlaceBuildings(Site* site);
void PlaceBoundaries(Site* site);
void PlaceVegetation(Site* site);
void PlaceRoadsideOfHighways(Site* site);
void PlacePeople(Site* site);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_WORLD_BUILDER_H_
