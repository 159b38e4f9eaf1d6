// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/vehicle_frame.h"

#include <cmath>

namespace semantic_kiss::evaluation {

using cartographer::transform::Rigid3d;

std::optional<VehicleFrame> GuessVehicleFrame(const std::vector<Rigid3d>& poses) {
  constexpr double kMinDriven_m = 1.;
  constexpr double kMinShare = 0.9;
  // Steps as the body sees them; noise cancels in their sum, turns do not matter.
  Eigen::Vector3d driven = Eigen::Vector3d::Zero();
  for (size_t i = 1; i < poses.size(); ++i) {
    driven +=
        poses[i - 1].rotation().conjugate() * (poses[i].translation() - poses[i - 1].translation());
  }
  const double distance_m = driven.norm();
  if (!(distance_m >= kMinDriven_m)) return std::nullopt;
  if (std::abs(driven.x()) >= kMinShare * distance_m) return VehicleFrame::kLidar;
  if (std::abs(driven.z()) >= kMinShare * distance_m) return VehicleFrame::kCamera;
  return std::nullopt;
}

const char* NameOf(VehicleFrame frame) {
  return frame == VehicleFrame::kCamera ? "camera" : "lidar";
}

Eigen::Vector3d UpAxis(VehicleFrame frame) {
  if (frame == VehicleFrame::kCamera) return -Eigen::Vector3d::UnitY();
  return Eigen::Vector3d::UnitZ();
}

}  // namespace semantic_kiss::evaluation
