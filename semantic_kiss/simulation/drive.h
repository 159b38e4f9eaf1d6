// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_DRIVE_H_
#define SEMANTIC_KISS_SIMULATION_DRIVE_H_

#include <cstdint>
#include <vector>

#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/simulation/hills.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// The true motion of the lidar: world_from_lidar at the end of every sweep. The car stands on the
// hills, so every visit of a place finds it at the same height and slope but for heave and sway.
std::vector<cartographer::transform::Rigid3d> DriveOverHills(const Route& route, const Hills& hills,
                                                             const proto::RouteOptions& options,
                                                             double mount_height_m, uint64_t seed);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_DRIVE_H_
