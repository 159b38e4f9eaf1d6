// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SEARCH_SPACE_H_
#define CARTOGRAPHER_SCAN_MATCHING_SEARCH_SPACE_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::scan_matching {

// How far from a guess is searched, to both sides.
struct SearchWindow {
  double linear_m = 0.;     // along x and along y, >= 0
  double angular_rad = 0.;  // >= 0; pi or more: all headings
};

// A grid of poses: every heading of `yaws_rad` with every shift by whole cells.
//
// Poses are in order: by the place of their heading in `yaws_rad`, then y, then x. Of poses with
// the same score the first one counts.
struct SearchSpace {
  Eigen::Vector2d origin{0., 0.};  // [m], the translation of shift (0, 0)
  submap::CellIndex first_shift{0, 0};
  submap::CellIndex num_shifts{0, 0};
  std::vector<double> yaws_rad;

  PlanarPose PoseAt(size_t yaw, const submap::CellIndex& shift, double resolution_m) const;
};

// The poses within `window` around the guess, which is one of them. Headings are evenly spaced, at
// most so far from each other that a point at `radius_m` moves by a cell, and those nearest the
// guess come first. All must be finite (CHECKed).
SearchSpace SpaceAround(const PlanarPose& guess, const SearchWindow& window, double resolution_m,
                        double radius_m);

// All headings and all translations to the centres of the cells within `box`.
SearchSpace WholeSpace(const submap::SemanticGrid::CellBox& box, double resolution_m,
                       double radius_m);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SEARCH_SPACE_H_
