// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_RECORDED_ROUTE_H_
#define SEMANTIC_KISS_SIMULATION_RECORDED_ROUTE_H_

#include <cstdint>

#include "absl/status/statusor.h"
#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"

namespace semantic_kiss::simulation {

// camera_from_lidar of KITTI's car (near that of its sequences 04-12): with it recorded camera
// poses become lidar poses, and it is what simulated calib.txt files say.
cartographer::transform::Rigid3d CameraFromLidar();

// The route of a ground-truth file; side streets are guessed where it turns and at random.
absl::StatusOr<Route> ReadRecordedRoute(const proto::RouteOptions& options, double scan_rate_hz,
                                        uint64_t seed);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_RECORDED_ROUTE_H_
