// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_RELATIVE_ERROR_H_
#define SEMANTIC_KISS_EVALUATION_RELATIVE_ERROR_H_

#include <array>
#include <optional>
#include <vector>

#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss::evaluation {

// Lengths of the segments over which drift is measured.
inline constexpr std::array<double, 8> kSegmentLengths_m = {100., 200., 300., 400.,
                                                            500., 600., 700., 800.};
// A segment starts at every so many poses.
inline constexpr int kSegmentStep = 10;

// Drift per driven distance, a mean over segments.
struct RelativeError {
  double translation_percent = 0.;
  double rotation_deg_per_m = 0.;
  int num_segments = 0;
};

// The same for the segments of one length; fields are 0 if there are none.
struct RelativeErrorOfLength {
  double length_m = 0.;
  RelativeError error;
};

// RTE as the KITTI odometry benchmark defines it.
struct RelativeErrors {
  RelativeError overall;
  std::vector<RelativeErrorOfLength> by_length;  // one for each of kSegmentLengths_m, in order
};

// Distance driven up to each pose [m]: the sum of the straight steps between poses; 0 for the
// first. Empty for no poses.
std::vector<double> DrivenDistances(const std::vector<cartographer::transform::Rigid3d>& poses);

// Compares the motion over segments of the drive. A segment starts at every kSegmentStep-th pose
// and ends at the first pose more than its length farther along the ground truth; there are none
// where the drive ends before. Its error is the motion
//   (estimate_first^-1 estimate_last)^-1 (truth_first^-1 truth_last),
// its translation [m] and its angle, divided by the segment's nominal length. Every segment of
// every length has the same weight in `overall`.
//
// Both trajectories are poses of the same body, world_from_body; the worlds may differ. Sizes must
// be equal and all poses finite (CHECKed). Absent if there is no segment, which is so under 100 m.
// Source: Geiger et al., CVPR 2012, and the benchmark's published definition.
std::optional<RelativeErrors> ComputeRelativeErrors(
    const std::vector<cartographer::transform::Rigid3d>& ground_truth,
    const std::vector<cartographer::transform::Rigid3d>& estimate);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_RELATIVE_ERROR_H_
