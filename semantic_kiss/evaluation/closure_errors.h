// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_CLOSURE_ERRORS_H_
#define SEMANTIC_KISS_EVALUATION_CLOSURE_ERRORS_H_

#include <optional>
#include <vector>

#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss::evaluation {

// What a loop closure claims: where scan `revisit` was taken, seen from scan `earlier`.
struct ClosureClaim {
  int earlier = 0;
  int revisit = 0;
  cartographer::transform::Rigid3d earlier_from_revisit;
  // Only x, y and heading are claimed, between both scans' level frames.
  bool in_plane = false;
};

struct ClosureError {
  double distance_m = 0.;
  double angle_deg = 0.;
  // Beyond this a closure would bend a map instead of mending it.
  bool False() const { return distance_m > 1. || angle_deg > 2.; }
};

// How wrong each claim is, in what it claims. `truth`: poses of the sensor in a level frame, one
// for each scan; the claims' indices must be valid (CHECKed).
std::vector<ClosureError> ClosureErrors(const std::vector<ClosureClaim>& claims,
                                        const std::vector<cartographer::transform::Rigid3d>& truth);

// Where the drive comes by places where it was before, and how much of that was noticed.
struct RevisitCoverage {
  double revisited_m = 0.;  // of the route
  double closed_m = 0.;     // of these, with a closure nearby
  // nullopt if nothing was revisited.
  std::optional<double> ClosedShare() const {
    if (revisited_m <= 0.) return std::nullopt;
    return closed_m / revisited_m;
  }
};

struct RevisitOptions {
  double max_distance_m = 6.;    // between the positions of both visits, in space
  double min_travel_m = 100.;    // driven in between, or it is the same visit
  double closure_reach_m = 10.;  // how much of the route a closure speaks for, to both sides
};

RevisitCoverage ComputeRevisitCoverage(const std::vector<ClosureClaim>& claims,
                                       const std::vector<cartographer::transform::Rigid3d>& truth,
                                       const RevisitOptions& options);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_CLOSURE_ERRORS_H_
