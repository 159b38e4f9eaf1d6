// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_GROUND_PROFILE_H_
#define SEMANTIC_KISS_SIMULATION_GROUND_PROFILE_H_

#include <Eigen/Core>
#include <vector>

#include "semantic_kiss/simulation/ground.h"

namespace semantic_kiss::simulation {

// The ground along a line in the plane as it is seen from a point above the line's start: tells how
// far rays that leave this point near the line need not be compared with the ground.
class GroundProfile {
 public:
  // `ground` must outlive the profile.
  GroundProfile(const Ground& ground, double reach_m);

  // Looks along the line through `origin` with the planar unit vector `heading`.
  void Take(const Eigen::Vector3d& origin, const Eigen::Vector2d& heading);

  // Up to this distance in the plane a ray that rises by `slope` a metre is above the ground;
  // infinity if it is up to the reach. Kerbs beside the line, and tufts between the samples, are
  // allowed for by a hand's breadth, so the answer may rarely be wrong by one of them.
  double ClearUntil(double slope) const;

 private:
  const Ground& ground_;
  std::vector<double> distances_m_;
  // The steepest slope at which ground is seen up to each distance: never falls.
  std::vector<double> horizon_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_GROUND_PROFILE_H_
