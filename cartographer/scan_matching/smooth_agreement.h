// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SMOOTH_AGREEMENT_H_
#define CARTOGRAPHER_SCAN_MATCHING_SMOOTH_AGREEMENT_H_

#include <Eigen/Core>

#include "cartographer/scan_matching/score_pyramid.h"

namespace cartographer::scan_matching {

// The agreement of cells (score_model.h) as a smooth function of the plane: cubic B-splines whose
// coefficients are the cells' values, so that it is the cells blurred by a little more than half a
// cell, twice continuously differentiable, in [0, 1], and 0 two cells away from all hits.
class SmoothAgreement {
 public:
  // Keeps a pointer: the pyramid must outlive this. `resolution_m` is the side of its cells.
  SmoothAgreement(const ScorePyramid& pyramid, double resolution_m)
      : pyramid_(pyramid), resolution_m_(resolution_m) {}

  struct Sample {
    double value;              // in [0, 1]
    Eigen::Vector2d gradient;  // [1 / m]
  };
  // For a point of a layer of the model, at a position in the grid's frame [m].
  Sample At(int layer, const Eigen::Vector2d& position) const;

 private:
  const ScorePyramid& pyramid_;
  const double resolution_m_;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SMOOTH_AGREEMENT_H_
