// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_REFINE_IN_PLANE_H_
#define CARTOGRAPHER_SCAN_MATCHING_REFINE_IN_PLANE_H_

#include <Eigen/Core>

#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/proto/scan_matching_options.pb.h"
#include "cartographer/scan_matching/solve_in_plane.h"
#include "cartographer/scan_matching/submap_matcher.h"

namespace cartographer::scan_matching {

// What refinement minimizes half the squared norm of: for every point of the scan, in its order,
//
//   r_i = sqrt(w_i / sum_k w_k) (1 - v(y_i, R s_i + t)),
//
// v the smoothed agreement of smooth_agreement.h at the point's place, w its weight. At the truth
// the sum of squares is small; it is 1 where nothing agrees.
class AgreementResiduals : public PlanarResiduals {
 public:
  // Keeps references: both must outlive this. The scan must not be empty (CHECKed).
  AgreementResiduals(const SubmapMatcher& matcher, const MatchingScan& scan);

  int size() const override { return static_cast<int>(scan_.size()); }
  void Evaluate(const PlanarPose& submap_from_node, double* residuals,
                double* jacobian) const override;

 private:
  const SubmapMatcher& matcher_;
  const MatchingScan& scan_;
};

struct PlanarRefinement {
  // The guess, if there is nothing to go by or if refinement left it by more than the options
  // allow.
  PlanarPose submap_from_node;
  bool refined = false;
  // 1 - sum of r_i^2 there, in [0, 1].
  double agreement = 0.;
};

// Moves a match from the lattice of the search to the nearest optimum of the smoothed score, to a
// fraction of a cell. `guess` should be within a cell or two of the optimum.
PlanarRefinement RefineInPlane(const SubmapMatcher& matcher, const MatchingScan& scan,
                               const PlanarPose& guess, const proto::RefinementOptions& options);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_REFINE_IN_PLANE_H_
