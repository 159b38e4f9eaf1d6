// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_SEMANTIC_ICP_H_
#define CARTOGRAPHER_REGISTRATION_SEMANTIC_ICP_H_

#include "absl/strings/string_view.h"
#include "cartographer/registration/labeled_voxel_map.h"
#include "cartographer/registration/proto/registration_options.pb.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::registration {

enum class IcpOutcome {
  kConverged,
  kIterationLimit,     // the last estimate is reported: usable, but it had not settled
  kTooFewPoints,       // the source is too small to say anything
  kNoCorrespondences,  // too few pairs within the gate, or all of weight 0
  kDegenerate          // the pairs leave a rotation undetermined
};

// "converged", "iteration_limit", ...: the words of reports.
absl::string_view OutcomeName(IcpOutcome outcome);

// How far a pair may be apart and how fast its weight falls.
struct IcpScale {
  double gate_m;        // largest distance of a pair, > 0 (CHECKed)
  double kernel_scale;  // sigma of the Geman-McClure kernel, > 0 (CHECKed)
};

struct IcpReport {
  IcpOutcome outcome = IcpOutcome::kTooFewPoints;
  // The estimate if the outcome is kConverged or kIterationLimit, else the guess unchanged.
  transform::Rigid3d map_from_source;
  int iterations = 0;
  // Of the last iteration:
  int num_correspondences = 0;
  double inlier_ratio = 0.;  // pairs / source points
  double rms_error_m = 0.;   // of the pairs
  int num_agreeing = 0;      // pairs whose labels are known and equal
  double last_step = 0.;     // what is compared with the convergence threshold

  bool HasEstimate() const {
    return outcome == IcpOutcome::kConverged || outcome == IcpOutcome::kIterationLimit;
  }
};

// kappa, the certainty weight of a pair (the paper, "semantic KISS-ICP"): the probability
// P(y_s | u) of the source's label if both labels agree, 1 - P if they don't; `unlabeled_weight`
// if either side is unlabeled.
double CertaintyWeight(sensor::Label source, float certainty, sensor::Label target,
                       double unlabeled_weight);

// Aligns a cloud to a map, point to point: minimizes
//
//   sum over pairs of rho(|r|^2) * kappa * |r|^2,   r = map_from_source * s - q,
//
// q the map's point nearest to s (by the measure of FindPreferred() if `agreeing_distance_factor`
// is not 1), rho the Geman-McClure weight, kappa the certainty weight, by
// Gauss-Newton steps multiplied from the left, with new pairs in each iteration. Steps are taken
// about the source's origin rather than the map's: the same steps, but well conditioned and with
// the same stopping criterion everywhere.
//
//   source            N points in their own frame [m], finite, N >= 0
//   map_from_guess    predicted pose of that frame
//
// Parallel inside; bit-identical on any number of threads.
// Source: Vizzo et al., "KISS-ICP", RA-L 2023, section III-D; kappa from "A Chef's KISS".
IcpReport AlignCloud(const sensor::LabeledPointCloud& source, const LabeledVoxelMap& map,
                     const transform::Rigid3d& map_from_guess, const IcpScale& scale,
                     const proto::IcpOptions& options);

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_SEMANTIC_ICP_H_
