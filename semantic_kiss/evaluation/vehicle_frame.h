// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_VEHICLE_FRAME_H_
#define SEMANTIC_KISS_EVALUATION_VEHICLE_FRAME_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss::evaluation {

// The body on the vehicle whose poses a trajectory tells, so which of its axes points up or down.
enum class VehicleFrame {
  kCamera,  // KITTI's left camera: x right, y down, z forward; heights are along y
  kLidar    // x forward, y left, z up; heights are along z
};

// Tells the frame by the axis along which the vehicle drives. Absent if that is not clear: under
// 1 m driven, or not mostly along one of the two.
std::optional<VehicleFrame> GuessVehicleFrame(
    const std::vector<cartographer::transform::Rigid3d>& poses);

// "camera" or "lidar".
const char* NameOf(VehicleFrame frame);

// Unit vector upwards in that frame.
Eigen::Vector3d UpAxis(VehicleFrame frame);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_VEHICLE_FRAME_H_
