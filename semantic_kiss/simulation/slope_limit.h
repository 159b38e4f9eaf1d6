// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SLOPE_LIMIT_H_
#define SEMANTIC_KISS_SIMULATION_SLOPE_LIMIT_H_

#include <vector>

#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// Heights [m] of `poses`, one each, in which no stretch of 10 m along the way rises or falls by
// more than `max_slope` (rise over run): where the recording is steeper, which no road is, its rise
// there is scaled down and all that follows keeps its shape, shifted. Heights of a route without
// such stretches come back bit for bit. The last stretch may be shorter; a car that stands on it is
// not lifted at all.
std::vector<double> LimitSlopes(const std::vector<PlanarPose>& poses,
                                const std::vector<double>& heights_m, double max_slope);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SLOPE_LIMIT_H_
