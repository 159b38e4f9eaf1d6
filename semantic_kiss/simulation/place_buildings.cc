// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/site.h"
#include "semantic_kiss/simulation/world_builder.h"

namespace semantic_kiss::simulation {
namespace {

// How urban a place is: 0 a suburb of houses in gardens, 1 closed fronts along the sidewalk.
double Urbanity(const Site& site, const Eigen::Vector2d& p) {
  const uint64_t key = HashKey({site.seed, static_cast<uint64_t>(Purpose::kBuilding)});
  return std::clamp(0.3 + 0.9 * SmoothNoise(key, p.x() / 130., p.y() / 130.), 0., 1.);
}

double LowestGround(const Site& site, const Footprint& footprint) {
  double lowest_m = site.ground->Height(footprint.centre);
  for (const double u : {-1., 1.}) {
    for (const double v : {-1., 1.}) {
      lowest_m = std::min(lowest_m, site.ground->Height(footprint.At(u, v)));
    }
  }
  return lowest_m;
}

Primitive Block(const Footprint& footprint, double bottom_m, double top_m, uint32_t object) {
  Primitive block;
  block.object = object;
  block.centre << footprint.centre, 0.5 * (bottom_m + top_m);
  block.SetYaw(footprint.yaw);
  block.half << footprint.half_length_m, footprint.half_width_m, 0.5 * (top_m - bottom_m);
  return block;
}

// Walls and a roof whose ridge runs along the footprint's length.
void Raise(const Footprint& footprint, double height_m, double roof_m, Random* random, Site* site) {
  const uint32_t object = site->NextStatic();
  const double bottom_m = LowestGround(*site, footprint) - 0.3;
  const double eaves_m = bottom_m + 0.3 + height_m;
  Primitive walls = Block(footprint, bottom_m, eaves_m, object);
  walls.texture = Texture::kFacade;
  walls.material = material::kWall;
  walls.material.remission = static_cast<float>(random->Uniform(0.22, 0.6));
  Primitive roof = Block(footprint, eaves_m, eaves_m + std::max(0.25, roof_m), object);
  roof.material = material::kRoof;
  roof.half.head<2>().array() += 0.3;  // eaves
  if (roof_m > 0.) {
    roof.taper[2] = roof.taper[3] = static_cast<float>(roof.half.y() / (2. * roof.half.z()));
    if (random->Chance(0.4)) roof.taper[0] = roof.taper[1] = 0.5f;
  }
  site->Add({walls, roof});
}

// What breaks a front's plane: bays, porches and balconies toward the street.
void AddOutworks(const Footprint& house, double toward, double height_m, Random* random,
                 Site* site) {
  const uint32_t object = site->NextStatic();
  const int count = random->Index(4);
  for (int i = 0; i < count; ++i) {
    const double depth_m = random->Uniform(0.3, 1.1);
    Footprint part{house.At(random->Uniform(-0.85, 0.85), toward), house.yaw,
                   random->Uniform(0.6, 1.8), depth_m};
    if (!site->IsFree(part, {1., 2.2})) continue;
    const double ground_m = LowestGround(*site, part);
    const bool balcony = height_m > 5. && random->Chance(0.5);
    const double bottom_m = balcony ? ground_m + random->Uniform(2.6, 3.2) : ground_m - 0.3;
    const double top_m =
        balcony ? bottom_m + 1.1 : ground_m + std::min(height_m, random->Uniform(2.4, 5.5));
    Primitive block = Block(part, bottom_m, top_m, object);
    block.material = material::kWall;
    site->Add({block});
  }
}

void PlaceFrontRow(Site* site) {
  WalkKerbs(*site, Purpose::kBuilding, 0, [&](const Kerbside& kerb, Random& random) {
    if (kerb.centre->section.highway) return 20.;
    const double urbanity = Urbanity(*site, kerb.centre->pose.position);
    const double length_m = random.Uniform(9., 14. + 12. * urbanity);
    const double depth_m = random.Uniform(8., 12.);
    const double setback_m = std::max(0.3, random.Uniform(0.5, 1.) * 8. * (1. - urbanity) - 1.);
    const double height_m = 2.9 * (2 + random.Index(urbanity > 0.55 ? 4 : 2)) + 0.7;
    const double roof_m = random.Chance(0.8) ? random.Uniform(2.5, 4.5) : 0.;
    const double gap_m =
        random.Chance(0.25 + 0.3 * urbanity) ? 0.2 : random.Uniform(2.5, 9. - 4. * urbanity);
    if (!random.Chance(0.88 * site->options.building_density())) return length_m;
    const double outside_m = kerb.Property() + setback_m;
    Footprint house{kerb.At(outside_m + 0.5 * depth_m), kerb.Yaw(), 0.5 * length_m, 0.5 * depth_m};
    house.centre += 0.5 * length_m * kerb.centre->pose.Forward();
    if (!site->IsFree(house, {std::min(outside_m, kerb.Property()) - 0.3, 2.5})) return 3.;
    AddOutworks(house, -kerb.sign(), height_m, &random, site);
    site->Occupy(house);
    Raise(house, height_m, roof_m, &random, site);
    return length_m + gap_m;
  });
}

// Houses behind the first row close the view through its gaps.
void PlaceBackRows(Site* site) {
  WalkKerbs(*site, Purpose::kBuilding, 1, [&](const Kerbside& kerb, Random& random) {
    const bool highway = kerb.centre->section.highway;
    const double away_m = highway ? random.Uniform(35., 60.) : random.Uniform(20., 55.);
    const Footprint house{kerb.At(away_m), kerb.Yaw() + random.Uniform(-0.3, 0.3),
                          random.Uniform(5., 11.), random.Uniform(4., 7.)};
    const double height_m = 2.9 * (1 + random.Index(4)) + 0.7;
    const double density = site->options.building_density() * (highway ? 0.12 : 0.8);
    if (!random.Chance(density) || !site->IsFree(house, {12., 8.})) return 6.;
    site->Occupy(house);
    Raise(house, height_m, random.Uniform(2., 4.), &random, site);
    return 9.;
  });
}

}  // namespace

void PlaceBuildings(Site* site) {
  if (site->options.building_density() == 0.) return;
  PlaceFrontRow(site);
  PlaceBackRows(site);
}

}  // namespace semantic_kiss::simulation
