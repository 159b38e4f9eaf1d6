// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_FACADE_H_
#define SEMANTIC_KISS_SIMULATION_FACADE_H_

#include <cstdint>

#include "semantic_kiss/simulation/hit.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/ray.h"

namespace semantic_kiss::simulation {

// Deepest niche of a window behind the wall's plane [m].
inline constexpr double kDeepestNiche_m = 0.3;

// Moves a hit on a facade along its ray onto the wall's true surface: walls swell by
// `relief_m` (standard deviation), windows are set back and glazed. A wall looks the same from
// everywhere and on every day.
void ShapeFacade(const Primitive& wall, const Ray& ray, double relief_m, uint64_t seed, Hit* hit);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_FACADE_H_
