// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_CORRELATIVE_SEARCH_H_
#define CARTOGRAPHER_SCAN_MATCHING_CORRELATIVE_SEARCH_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/proto/planar_matching_options.pb.h"
#include "cartographer/submap/probability_grid.h"

namespace cartographer::scan_matching {

// The best of all poses around a guess, on a lattice of the grid's cells and of headings so close
// to one another that the farthest point moves by a cell at most: that of the highest score
//
//   mean over the points of P(cell under the point)
//     * exp(-(k_t |translation - guess|)^2 - (k_r |yaw - guess|)^2),
//
// the first one (by heading, y, x) on ties. Without points it is the guess.
//   points  of the scan, in its frame, in the plane [m]; of more than max_points every n-th counts,
//           with the smallest n that leaves so few
// Parallel inside; the same on any number of threads.
// Source: Olson, "Real-Time Correlative Scan Matching", ICRA 2009; the penalty as in Cartographer.
PlanarPose SearchAround(const submap::ProbabilityGrid& grid,
                        const std::vector<Eigen::Vector2d>& points,
                        const PlanarPose& grid_from_guess,
                        const proto::CorrelativeSearchOptions& options);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_CORRELATIVE_SEARCH_H_
