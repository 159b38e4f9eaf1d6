// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/slope_limit.h"

#include <cmath>
#include <cstddef>

#include "glog/logging.h"

namespace semantic_kiss::simulation {
namespace {

// Shorter stretches would take the noise of the recording for slopes.
constexpr double kStretch_m = 10.;

}  // namespace

std::vector<double> LimitSlopes(const std::vector<PlanarPose>& poses,
                                const std::vector<double>& heights_m, double max_slope) {
  CHECK_EQ(poses.size(), heights_m.size());
  std::vector<double> limited_m = heights_m;
  double shift_m = 0.;
  for (size_t first = 0; first + 1 < poses.size();) {
    size_t last = first;
    double run_m = 0.;
    while (last + 1 < poses.size() && run_m < kStretch_m) {
      run_m += (poses[last + 1].position - poses[last].position).norm();
      ++last;
    }
    const double rise_m = heights_m[last] - heights_m[first];
    const double removed_share =
        std::abs(rise_m) > max_slope * run_m ? 1. - max_slope * run_m / std::abs(rise_m) : 0.;
    for (size_t i = first + 1; i <= last; ++i) {
      limited_m[i] += shift_m - removed_share * (heights_m[i] - heights_m[first]);
    }
    shift_m -= removed_share * rise_m;
    first = last;
  }
  return limited_m;
}

}  // namespace semantic_kiss::simulation
