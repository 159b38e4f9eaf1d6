// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/site.h"
#include "semantic_kiss/simulation/things.h"
#include "semantic_kiss/simulation/world_builder.h"

namespace semantic_kiss::simulation {
namespace {

// Leaves keep this height where cars may pass below.
constexpr double kUnderCrown_m = 3.6;

double Greenness(const Site& site, const Eigen::Vector2d& p) {
  const uint64_t key = HashKey({site.seed, static_cast<uint64_t>(Purpose::kVegetation)});
  return std::max(0., site.options.vegetation_density() *
                          (1. + 0.9 * SmoothNoise(key, p.x() / 110., p.y() / 110.)));
}

// Rows of trees on the sidewalk.
void PlaceStreetTrees(Site* site) {
  WalkKerbs(*site, Purpose::kVegetation, 1, [&](const Kerbside& kerb, Random& random) {
    if (kerb.centre->section.highway) return 20.;
    if (Greenness(*site, kerb.centre->pose.position) < random.Uniform(1.1, 1.7)) return 12.;
    const Footprint pit{kerb.At(kerb.Sidewalk() + 0.8), kerb.Yaw(), 0.4, 0.4};
    if (!site->IsFree(pit, {0.35, 1.6})) return 3.;
    site->Occupy(pit);
    site->Add(MakeTree(site->StandAt(pit.centre, random.Uniform(0., 6.), site->NextStatic()),
                       kUnderCrown_m, random));
    return random.Uniform(8., 14.);
  });
}

// One tree or bush behind the sidewalk, if there is room at `away_m` from the carriageway.
void PlantAt(const Kerbside& kerb, double away_m, double nearest_m, double tree_share, Site* site,
             Random* random) {
  const bool tree = random->Chance(tree_share);
  const double half_m = tree ? 0.4 : 0.7;
  const Footprint foot{kerb.At(away_m), 0., half_m, half_m};
  if (!site->IsFree(foot, {nearest_m, 3.})) return;
  site->Occupy(foot);
  const Stand stand = site->StandAt(foot.centre, random->Uniform(0., 6.), site->NextStatic());
  const bool overhangs = site->streets.Outside(foot.centre) < 5.;
  site->Add(tree ? MakeTree(stand, overhangs ? kUnderCrown_m : 1.2, *random)
                 : MakeBush(stand, *random));
}

// Shrubs line the property, trees and bushes fill the gardens and verges behind it.
void PlaceGardens(Site* site) {
  WalkKerbs(*site, Purpose::kVegetation, 2, [&](const Kerbside& kerb, Random& random) {
    const double greenness = Greenness(*site, kerb.centre->pose.position);
    const bool highway = kerb.centre->section.highway;
    const double nearest_m = highway ? 4. : kerb.Property() + 0.4;
    if (random.Chance(std::min(1., greenness))) {
      PlantAt(kerb, nearest_m + random.Uniform(0.8, 3.), std::min(nearest_m, 5.),
              highway ? 0.3 : 0.12, site, &random);
    }
    if (random.Chance(std::min(1., greenness))) {
      const double away_m = nearest_m + 3. + 35. * std::pow(random.Uniform(), 1.5);
      PlantAt(kerb, away_m, std::min(nearest_m, 5.), 0.5, site, &random);
    }
    return random.Uniform(1., 2.);
  });
}

}  // namespace

void PlaceVegetation(Site* site) {
  if (site->options.vegetation_density() == 0.) return;
  PlaceStreetTrees(site);
  PlaceGardens(site);
}

}  // namespace semantic_kiss::simulation
