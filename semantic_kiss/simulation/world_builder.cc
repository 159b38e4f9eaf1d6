// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/world_builder.h"

#include <cmath>
#include <utility>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

void Pave(const Footprint& area, Cover cover, StreetMap* streets) {
  constexpr double kStep_m = 0.4;
  const int n = static_cast<int>(2. * area.half_length_m / kStep_m) + 1;
  const int m = static_cast<int>(2. * area.half_width_m / kStep_m) + 1;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) {
      streets->SetCover(area.At(2. * i / n - 1., 2. * j / m - 1.), cover);
    }
  }
}

}  // namespace

WorldBuilder::WorldBuilder(const proto::WorldOptions& options, uint64_t seed, int epoch,
                           StreetMap* streets)
    : site_(options, seed, epoch, streets) {}

void WorldBuilder::PlanLots() {
  WalkKerbs(site_, Purpose::kStreet, 1, [&](const Kerbside& kerb, Random& random) {
    const double next_m = random.Uniform(120., 400.);
    if (kerb.centre->section.highway || next_m > 260.) return next_m;
    const double depth_m = 17.;
    const Footprint lot{kerb.At(kerb.Property() + 0.5 * depth_m + 0.5), kerb.Yaw(),
                        random.Uniform(10., 20.), 0.5 * depth_m};
    if (!site_.IsFree(lot, {kerb.Property(), 3.})) return 10.;
    site_.Occupy(lot);
    lots_.push_back(lot);
    Pave(lot, Cover::kLot, &site_.streets);
    const double drive_m = 0.5 * (kerb.Property() - kerb.Sidewalk()) + 0.5;
    Pave({kerb.At(kerb.Sidewalk() + drive_m), kerb.Yaw(), 2.5, drive_m}, Cover::kLot,
         &site_.streets);
    return next_m;
  });
}

std::vector<Primitive> WorldBuilder::Build(const Ground& ground) {
  site_.ground = &ground;
  PlaceKerbsideVehicles(&site_);
  PlaceLotVehicles(lots_, &site_);
  PlaceStreetFurniture(&site_);
  PlaceBuildings(&site_);
  PlaceBoundaries(&site_);
  PlaceRoadsideOfHighways(&site_);
  PlaceVegetation(&site_);
  PlacePeople(&site_);
  return std::move(site_.primitives);
}

}  // namespace semantic_kiss::simulation
