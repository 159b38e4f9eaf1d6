// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_EPOCH_H_
#define SEMANTIC_KISS_SIMULATION_EPOCH_H_

#include <cstdint>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {

// What stands on a place for something movable on one day.
struct Tenant {
  bool present = false;
  // Seeds the thing's proportions: another variant is another thing.
  uint64_t variant = 0;
  double shift_m = 0.;  // along the place
  double turn_rad = 0.;
};

// The tenant of place `object`. On day 0 it is present with probability `occupancy`. On any other
// day the place is as on day 0 except with probability `change`: then the tenant has left, come,
// been replaced or shifted.
Tenant TenantOf(uint64_t seed, uint32_t object, int epoch, double occupancy, double change);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_EPOCH_H_
