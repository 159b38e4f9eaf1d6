// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_REDRIVE_H_
#define SEMANTIC_KISS_SIMULATION_REDRIVE_H_

#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// The same way as another driver takes it: `lane_offset_m` further to the left and `speed_factor`
// (> 0) times as fast, so with fewer or more scans; the last one may fall short of the route's end
// by one. With 0 and 1 the route itself, to the bit.
Route Redrive(const Route& route, double lane_offset_m, double speed_factor);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_REDRIVE_H_
