// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SYNTHETIC_ROUTES_H_
#define SEMANTIC_KISS_SIMULATION_SYNTHETIC_ROUTES_H_

#include <cstdint>

#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// Distance of a lane's middle from the street's, in towns.
inline constexpr double kLaneOffset_m = 1.8;

// A drive on the right-hand lanes of a net of streets with jittered crossings. It rounds a block,
// repeats one side of it in the same direction, rounds the next block and comes back on their
// common side in the opposite direction; then it wanders.
Route MakeCityRoute(const proto::RouteOptions& options, double scan_rate_hz, uint64_t seed);

// The right lane of a motorway with wide bends.
Route MakeHighwayRoute(const proto::RouteOptions& options, double scan_rate_hz, uint64_t seed);

// A ring road, driven counter-clockwise as often as the length asks for.
Route MakeLoopRoute(const proto::RouteOptions& options, double scan_rate_hz, uint64_t seed);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SYNTHETIC_ROUTES_H_
