// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_ALONG_PATH_H_
#define SEMANTIC_KISS_REPORT_ALONG_PATH_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/common/time.h"
#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss::report {

// What maps and charts tell of a way: one value for each pose.

std::vector<Eigen::Vector2d> PlanePositions(
    const std::vector<cartographer::transform::Rigid3d>& poses);

// Above the first pose [m].
std::vector<double> Heights(const std::vector<cartographer::transform::Rigid3d>& poses);

// [m/s], over the time from some poses before to some after, so that noise of single poses does not
// show; 0 where no time passes. As many times as poses (CHECKed).
std::vector<double> Speeds(const std::vector<cartographer::common::Time>& times,
                           const std::vector<cartographer::transform::Rigid3d>& poses);

// Distances between the positions of both [m], which must be as many (CHECKed).
std::vector<double> Distances(const std::vector<cartographer::transform::Rigid3d>& poses,
                              const std::vector<cartographer::transform::Rigid3d>& others);

// `poses`, moved as one (rotation and translation) such that their positions come as close as
// possible to those of `target`: as many (CHECKed), at least one. Under three the first positions
// are laid upon each other. Source: Umeyama, PAMI 1991.
std::vector<cartographer::transform::Rigid3d> AlignedOnto(
    const std::vector<cartographer::transform::Rigid3d>& target,
    const std::vector<cartographer::transform::Rigid3d>& poses);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_ALONG_PATH_H_
