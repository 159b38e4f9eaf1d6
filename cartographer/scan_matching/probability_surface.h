// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_PROBABILITY_SURFACE_H_
#define CARTOGRAPHER_SCAN_MATCHING_PROBABILITY_SURFACE_H_

#include <Eigen/Core>

#include "cartographer/submap/probability_grid.h"

namespace cartographer::scan_matching {

// The probabilities of a grid's cells as a smooth function of the plane: bicubic interpolation
// (Catmull-Rom) between the centres of cells, where it has the cells' values; once continuously
// differentiable. Not clamped: it overshoots a little beside steps.
class ProbabilitySurface {
 public:
  // Keeps a reference: the grid must outlive this.
  explicit ProbabilitySurface(const submap::ProbabilityGrid& grid) : grid_(grid) {}

  struct Sample {
    double value;
    Eigen::Vector2d gradient;  // [1 / m]
  };
  // At a position in the grid's frame [m].
  Sample At(const Eigen::Vector2d& position) const;

 private:
  const submap::ProbabilityGrid& grid_;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_PROBABILITY_SURFACE_H_
