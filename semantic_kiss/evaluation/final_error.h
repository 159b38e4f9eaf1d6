// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_FINAL_ERROR_H_
#define SEMANTIC_KISS_EVALUATION_FINAL_ERROR_H_

#include <vector>

#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/evaluation/vehicle_frame.h"

namespace semantic_kiss::evaluation {

// What has drifted between two poses of a drive, in the first one's frame; no alignment.
struct DriftError {
  double position_error_m = 0.;    // length of the whole
  double horizontal_error_m = 0.;  // its part in the plane
  double height_error_m = 0.;      // its part upwards: positive if the estimate ends too high
  double rotation_error_deg = 0.;  // angle of the whole rotation, in [0, 180]
  double heading_error_deg = 0.;   // its part about the upward axis, in (-180, 180]:
                                   // positive if the estimate turned too far to the left
};

// Compares the motion from the first pose to the last: cheap enough for every scan of a run. All
// poses are world_from_body; the worlds of truth and estimate may differ.
struct MotionEnds {
  cartographer::transform::Rigid3d first, last;
};
DriftError ComputeDriftError(const MotionEnds& ground_truth, const MotionEnds& estimate,
                             VehicleFrame frame);

// The same for whole trajectories of equal size, at least one pose (CHECKed).
DriftError ComputeFinalError(const std::vector<cartographer::transform::Rigid3d>& ground_truth,
                             const std::vector<cartographer::transform::Rigid3d>& estimate,
                             VehicleFrame frame);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_FINAL_ERROR_H_
