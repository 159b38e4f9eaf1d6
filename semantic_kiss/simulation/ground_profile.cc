// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/ground_profile.h"

#include <algorithm>
#include <limits>

namespace semantic_kiss::simulation {
namespace {

// From sample to sample: at the start, and its growth a metre.
constexpr double kFirstStep_m = 0.15;
constexpr double kStepGrowth = 0.01;
constexpr double kAllowance_m = 0.08;

}  // namespace

GroundProfile::GroundProfile(const Ground& ground, double reach_m) : ground_(ground) {
  for (double distance_m = kFirstStep_m; distance_m < reach_m;
       distance_m += kFirstStep_m + kStepGrowth * distance_m) {
    distances_m_.push_back(distance_m);
  }
  distances_m_.push_back(reach_m);
  horizon_.resize(distances_m_.size());
}

void GroundProfile::Take(const Eigen::Vector3d& origin, const Eigen::Vector2d& heading) {
  double steepest = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < distances_m_.size(); ++i) {
    const double height_m = ground_.Height(origin.head<2>() + distances_m_[i] * heading);
    steepest = std::max(steepest, (height_m + kAllowance_m - origin.z()) / distances_m_[i]);
    horizon_[i] = steepest;
  }
}

double GroundProfile::ClearUntil(double slope) const {
  const auto met = std::lower_bound(horizon_.begin(), horizon_.end(), slope);
  if (met == horizon_.end()) return std::numeric_limits<double>::infinity();
  if (met == horizon_.begin()) return 0.;
  return distances_m_[met - horizon_.begin() - 1];
}

}  // namespace semantic_kiss::simulation
