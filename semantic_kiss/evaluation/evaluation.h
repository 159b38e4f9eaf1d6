// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_EVALUATION_H_
#define SEMANTIC_KISS_EVALUATION_EVALUATION_H_

#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/evaluation/absolute_error.h"
#include "semantic_kiss/evaluation/final_error.h"
#include "semantic_kiss/evaluation/metrics.h"
#include "semantic_kiss/evaluation/relative_error.h"
#include "semantic_kiss/evaluation/vehicle_frame.h"

namespace semantic_kiss::evaluation {

// Everything that is known of an estimate's accuracy; docs/evaluation.md tells what each means.
struct Evaluation {
  double driven_m = 0.;  // along the ground truth
  std::optional<RelativeErrors> relative;
  std::optional<AbsoluteError> absolute_3d, absolute_2d;
  DriftError final_error;
};

// The four figures that tables show.
Metrics MetricsOf(const Evaluation& evaluation);

// The ground truth of the scans that were evaluated: `num_scans` poses from index `first_scan` on,
// or all the rest if that is absent. OutOfRange if there are no such poses.
absl::StatusOr<std::vector<cartographer::transform::Rigid3d>> GroundTruthOfScans(
    const std::vector<cartographer::transform::Rigid3d>& ground_truth, int first_scan,
    std::optional<int> num_scans);

// InvalidArgument, with the remedy, if one trajectory is plainly a camera's and the other a
// lidar's. Meant for files that people bring: an estimate that is lost may look so, too.
absl::Status CheckSameBody(const std::vector<cartographer::transform::Rigid3d>& ground_truth,
                           const std::vector<cartographer::transform::Rigid3d>& estimate);

// Compares an estimate with the ground truth, pose by pose; both are poses of the body `frame`.
// InvalidArgument, with the remedy, if there are no poses, if there are not as many of the one as
// of the other (cut the truth to the scans of the run first: GroundTruthOfScans), or if a pose is
// not finite.
absl::StatusOr<Evaluation> Evaluate(
    const std::vector<cartographer::transform::Rigid3d>& ground_truth,
    const std::vector<cartographer::transform::Rigid3d>& estimate, VehicleFrame frame);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_EVALUATION_H_
