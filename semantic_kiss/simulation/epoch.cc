// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/epoch.h"

namespace semantic_kiss::simulation {
namespace {

Tenant Draw(Random* random, double occupancy) {
  Tenant tenant;
  tenant.present = random->Chance(occupancy);
  tenant.variant = random->Next();
  tenant.shift_m = random->Uniform(-0.35, 0.35);
  tenant.turn_rad = 0.03 * random->Normal();
  return tenant;
}

}  // namespace

Tenant TenantOf(uint64_t seed, uint32_t object, int epoch, double occupancy, double change) {
  Random first_day(seed, Purpose::kVehicle, object, 0);
  Tenant tenant = Draw(&first_day, occupancy);
  if (epoch == 0) return tenant;
  Random today(seed, Purpose::kVehicle, object, static_cast<uint64_t>(epoch));
  if (!today.Chance(change)) return tenant;
  const Tenant other = Draw(&today, occupancy);
  if (!tenant.present) return other;
  const double fate = today.Uniform();
  if (fate < 0.4) {
    tenant.present = false;
  } else if (fate < 0.75) {
    tenant = other;
    tenant.present = true;
  } else {
    const double away_m = today.Uniform(0.3, 0.7);
    tenant.shift_m += tenant.shift_m > 0. ? -away_m : away_m;
    tenant.turn_rad = other.turn_rad;
  }
  return tenant;
}

}  // namespace semantic_kiss::simulation
