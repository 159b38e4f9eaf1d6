// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "semantic_kiss/simulation/epoch.h"
#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/site.h"
#include "semantic_kiss/simulation/things.h"
#include "semantic_kiss/simulation/world_builder.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kKerbsideGap_m = 5.6;  // from car to car
constexpr double kLotGap_m = 2.6;

// Puts today's tenant, if any, on a place that is already occupied. `yaw` is the place's length.
void Settle(const Footprint& place, double yaw, double occupancy, Site* site) {
  const uint32_t object = site->NextMovable();
  const Tenant tenant =
      TenantOf(site->seed, object, site->epoch, occupancy, site->options.epoch_change());
  if (!tenant.present) return;
  const Eigen::Vector2d along(std::cos(yaw), std::sin(yaw));
  const Stand stand =
      site->StandAt(place.centre + tenant.shift_m * along, yaw + tenant.turn_rad, object);
  site->Add(MakeCar(stand, false, Random(tenant.variant)));
}

double Crowd(const Site& site, const Eigen::Vector2d& position) {
  const uint64_t key = HashKey({site.seed, static_cast<uint64_t>(Purpose::kVehicle)});
  const double noise = SmoothNoise(key, position.x() / 90., position.y() / 90.);
  return std::min(0.95, site.options.parked_vehicle_density() * (0.38 + 0.5 * noise));
}

void PlaceTruck(const Kerbside& kerb, Site* site, Random* random) {
  const Footprint place{kerb.At(1.2), kerb.Yaw(), 0.5 * kTruckLength_m + 0.3, 1.15};
  const uint32_t object = site->NextMovable();
  if (!site->IsFree(place, {0., 1.5})) return;
  site->Occupy(place);
  const Tenant tenant =
      TenantOf(site->seed, object, site->epoch, random->Uniform(), site->options.epoch_change());
  if (!tenant.present) return;
  site->Add(MakeTruck(site->StandAt(place.centre, kerb.TrafficYaw(), object), false,
                      Random(tenant.variant)));
}

}  // namespace

void PlaceKerbsideVehicles(Site* site) {
  if (site->options.parked_vehicle_density() == 0.) return;
  WalkKerbs(*site, Purpose::kVehicle, 0, [&](const Kerbside& kerb, Random& random) {
    if (kerb.centre->section.parking_m[kerb.side] == 0.) return 3.;
    if (random.Chance(0.02)) {
      PlaceTruck(kerb, site, &random);
      return kTruckLength_m + 1.5;
    }
    const double outside_m = random.Uniform(0.95, 1.15);
    const Footprint place{kerb.At(outside_m), kerb.Yaw(), 0.5 * kCarLength_m + 0.4,
                          0.5 * kCarWidth_m};
    if (!site->IsFree(place, {0., 1.5})) return 2.;
    site->Occupy(place);
    const bool wrong_way = random.Chance(0.1);
    Settle(place, kerb.TrafficYaw() + (wrong_way ? M_PI : 0.), Crowd(*site, place.centre), site);
    return kKerbsideGap_m + random.Uniform(0., 0.8);
  });
}

void PlaceLotVehicles(const std::vector<Footprint>& lots, Site* site) {
  if (site->options.parked_vehicle_density() == 0.) return;
  for (const Footprint& lot : lots) {
    for (const double row : {-0.66, 0.66}) {
      const double in_row = lot.half_length_m - 1.5;
      for (double x = -in_row; x < in_row; x += kLotGap_m) {
        Footprint place = lot;
        place.centre = lot.At(x / lot.half_length_m, row);
        Settle(place, lot.yaw + (row > 0. ? 0.5 : -0.5) * M_PI,
               std::min(0.9, 0.6 * site->options.parked_vehicle_density()), site);
      }
    }
  }
}

void PlacePeople(Site* site) {
  if (site->options.person_density() == 0.) return;
  WalkKerbs(*site, Purpose::kPerson, 0, [&](const Kerbside& kerb, Random& random) {
    const double next_m = random.Uniform(15., 90.) / site->options.person_density();
    if (kerb.centre->section.highway) return next_m;
    const Footprint place{kerb.At(kerb.Sidewalk() + random.Uniform(0.4, 2.)), 0., 0.3, 0.3};
    if (!site->IsFree(place, {kerb.Sidewalk() + 0.2, 1.5})) return 3.;
    site->Occupy(place);
    const uint32_t object = site->NextMovable();
    const Tenant tenant =
        TenantOf(site->seed, object, site->epoch, 0.7, site->options.epoch_change());
    if (!tenant.present) return next_m;
    Random variant(tenant.variant);
    const Stand stand = site->StandAt(place.centre, variant.Uniform(0., 2. * M_PI), object);
    site->Add(variant.Chance(0.7) ? MakePerson(stand, false, variant)
                                  : MakeCyclist(stand, false, variant));
    return next_m;
  });
}

}  // namespace semantic_kiss::simulation
