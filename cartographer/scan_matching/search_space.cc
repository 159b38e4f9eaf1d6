// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/search_space.h"

#include <algorithm>
#include <cmath>

#include "glog/logging.h"

namespace cartographer::scan_matching {
namespace {

// The turn by which a point at radius_m moves by a cell (the chord is as long as a cell's side).
double YawStep(double resolution_m, double radius_m) {
  return 2. * std::asin(std::min(1., resolution_m / (2. * std::max(radius_m, resolution_m))));
}

double Normalized(double yaw_rad) { return std::remainder(yaw_rad, 2. * M_PI); }

// `center`, then the headings at 1, 2, ... steps on both sides, left ones first.
std::vector<double> YawsAround(double center, int steps_left, int steps_right, double step) {
  std::vector<double> yaws = {Normalized(center)};
  for (int i = 1; i <= std::max(steps_left, steps_right); ++i) {
    if (i <= steps_left) yaws.push_back(Normalized(center + i * step));
    if (i <= steps_right) yaws.push_back(Normalized(center - i * step));
  }
  return yaws;
}

std::vector<double> AllYaws(double center, double max_step) {
  const int count = static_cast<int>(std::ceil(2. * M_PI / max_step));
  return YawsAround(center, count / 2, (count - 1) / 2, 2. * M_PI / count);
}

}  // namespace

PlanarPose SearchSpace::PoseAt(size_t yaw, const submap::CellIndex& shift,
                               double resolution_m) const {
  return {origin + shift.cast<double>().matrix() * resolution_m, yaws_rad[yaw]};
}

SearchSpace SpaceAround(const PlanarPose& guess, const SearchWindow& window, double resolution_m,
                        double radius_m) {
  CHECK(guess.translation.allFinite() && std::isfinite(guess.yaw_rad));
  CHECK(std::isfinite(window.linear_m) && std::isfinite(window.angular_rad));
  CHECK(window.linear_m >= 0. && window.angular_rad >= 0.);
  SearchSpace space;
  space.origin = guess.translation;
  // Round-off must not add a row of cells to a window that is a whole number of them.
  const int reach = static_cast<int>(std::ceil(window.linear_m / resolution_m - 1e-9));
  space.first_shift = submap::CellIndex::Constant(-reach);
  space.num_shifts = submap::CellIndex::Constant(2 * reach + 1);
  const double max_step = YawStep(resolution_m, radius_m);
  if (window.angular_rad >= M_PI) {
    space.yaws_rad = AllYaws(guess.yaw_rad, max_step);
  } else {
    const int steps = static_cast<int>(std::ceil(window.angular_rad / max_step));
    space.yaws_rad =
        YawsAround(guess.yaw_rad, steps, steps, steps == 0 ? 0. : window.angular_rad / steps);
  }
  return space;
}

SearchSpace WholeSpace(const submap::SemanticGrid::CellBox& box, double resolution_m,
                       double radius_m) {
  SearchSpace space;
  space.origin = Eigen::Vector2d::Constant(0.5 * resolution_m);
  space.first_shift = box.min;
  space.num_shifts = box.max - box.min;
  space.yaws_rad = AllYaws(0., YawStep(resolution_m, radius_m));
  return space;
}

}  // namespace cartographer::scan_matching
