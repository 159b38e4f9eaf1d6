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

void PlaceLamps(Site* site) {
  WalkKerbs(*site, Purpose::kFurniture, 0, [&](const Kerbside& kerb, Random& random) {
    const double next_m = random.Uniform(30., 45.) / site->options.furniture_density();
    if (kerb.centre->section.highway || random.Chance(0.3)) return next_m;
    const Footprint foot{kerb.At(kerb.Sidewalk() + 0.45), kerb.Yaw(), 0.15, 0.15};
    if (!site->IsFree(foot, {0.25, 1.6})) return 4.;
    site->Occupy(foot);
    site->Add(MakeLamp(site->StandAt(foot.centre, kerb.InwardYaw(), site->NextStatic()), random));
    return next_m;
  });
}

void PlaceSigns(Site* site) {
  WalkKerbs(*site, Purpose::kFurniture, 1, [&](const Kerbside& kerb, Random& random) {
    const double next_m = random.Uniform(20., 80.) / site->options.furniture_density();
    const bool highway = kerb.centre->section.highway;
    const double outside_m = highway ? 2. : kerb.Sidewalk() + random.Uniform(0.3, 0.6);
    const Footprint foot{kerb.At(outside_m), kerb.Yaw(), 0.15, 0.15};
    if (!site->IsFree(foot, {0.2, 1.6})) return 3.;
    site->Occupy(foot);
    const Stand stand =
        site->StandAt(foot.centre, kerb.TrafficYaw() + 0.1 * random.Normal(), site->NextStatic());
    site->Add(random.Chance(0.15) && !highway ? MakeTrafficLight(stand, random)
                                              : MakeTrafficSign(stand, random));
    return next_m;
  });
}

void PlaceBins(Site* site) {
  WalkKerbs(*site, Purpose::kFurniture, 2, [&](const Kerbside& kerb, Random& random) {
    const double next_m = random.Uniform(50., 200.) / site->options.furniture_density();
    if (kerb.centre->section.highway) return next_m;
    const Footprint foot{kerb.At(kerb.Property() - 0.3), kerb.Yaw(), 0.4, 0.4};
    if (!site->IsFree(foot, {0.5, 1.6})) return 3.;
    site->Occupy(foot);
    site->Add(MakeBin(site->StandAt(foot.centre, kerb.Yaw(), site->NextStatic()), random));
    return next_m;
  });
}

}  // namespace

void PlaceStreetFurniture(Site* site) {
  if (site->options.furniture_density() == 0.) return;
  PlaceLamps(site);
  PlaceSigns(site);
  PlaceBins(site);
}

void PlaceBoundaries(Site* site) {
  constexpr double kPanel_m = 3.;
  if (site->options.furniture_density() == 0.) return;
  struct Property {
    BarrierKind kind = BarrierKind::kHedge;
    double height_m = 1.;
    double left_m = 0.;  // to go along it
    bool open = false;
  } property;
  WalkKerbs(*site, Purpose::kVegetation, 0, [&](const Kerbside& kerb, Random& random) {
    if (kerb.centre->section.highway) return kPanel_m;
    property.left_m -= kPanel_m;
    if (property.left_m < 0.) {
      const double kind = random.Uniform();
      property.kind = kind < 0.7   ? BarrierKind::kHedge
                      : kind < 0.9 ? BarrierKind::kFence
                                   : BarrierKind::kWall;
      property.height_m = random.Uniform(0.8, property.kind == BarrierKind::kHedge ? 2.4 : 1.6);
      property.left_m = random.Uniform(8., 25.);
      property.open = random.Chance(0.1);
    }
    if (property.open || random.Chance(0.12)) return kPanel_m;
    Footprint panel{kerb.At(kerb.Property() + 0.5), kerb.Yaw(), 0.5 * kPanel_m, 0.3};
    if (!site->IsFree(panel, {kerb.Property() - 0.2, 2.2})) return kPanel_m;
    site->Occupy(panel);
    const Stand from = site->StandAt(panel.At(-1., 0.), 0., 0);
    const Stand to = site->StandAt(panel.At(1., 0.), 0., 0);
    site->Add(
        MakeBarrier(from.foot, to.foot, property.kind, property.height_m, site->NextStatic()));
    return kPanel_m;
  });
}

void PlaceRoadsideOfHighways(Site* site) {
  constexpr double kPanel_m = 4.;
  WalkKerbs(*site, Purpose::kFurniture, 3, [&](const Kerbside& kerb, Random& random) {
    if (!kerb.centre->section.highway) return kPanel_m;
    const double half_width_m = kerb.centre->section.half_width_m;
    for (const double outside_m : {0.6, 0.6 - half_width_m}) {
      if (outside_m > 0. && random.Chance(0.25)) continue;
      const Footprint panel{kerb.At(outside_m), kerb.Yaw(), 0.5 * kPanel_m, 0.1};
      if (!site->IsFree(panel, {outside_m - 0.6, 2.2})) continue;
      site->Add(MakeBarrier(site->StandAt(panel.At(-1., 0.), 0., 0).foot,
                            site->StandAt(panel.At(1., 0.), 0., 0).foot, BarrierKind::kGuardRail,
                            0.75, site->NextStatic()));
    }
    // Reflector posts.
    if (static_cast<int>(kerb.centre->arc_m) % 40 < static_cast<int>(kPanel_m)) {
      const Footprint foot{kerb.At(1.3), kerb.Yaw(), 0.1, 0.1};
      if (site->IsFree(foot, {0.9, 2.})) {
        site->Add({MakeTrafficLight(site->StandAt(foot.centre, kerb.Yaw(), site->NextStatic()),
                                    random)[0]});
      }
    }
    return kPanel_m;
  });
}

}  // namespace semantic_kiss::simulation
