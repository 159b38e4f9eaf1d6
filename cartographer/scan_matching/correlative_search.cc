// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/correlative_search.h"

#include <algorithm>
#include <cmath>

#include "cartographer/common/parallel.h"

namespace cartographer::scan_matching {
namespace {

using submap::CellIndex;

struct Candidate {
  double score = -1.;
  CellIndex shift{0, 0};
  int turn = 0;
};

std::vector<Eigen::Vector2d> Thin(const std::vector<Eigen::Vector2d>& points, size_t max_points) {
  const size_t stride = (points.size() + max_points - 1) / max_points;
  std::vector<Eigen::Vector2d> kept;
  for (size_t i = 0; i < points.size(); i += stride) kept.push_back(points[i]);
  return kept;
}

// The angle by which the farthest point moves by a cell.
double AngularStep(const submap::ProbabilityGrid& grid,
                   const std::vector<Eigen::Vector2d>& points) {
  double farthest = grid.resolution_m();
  for (const Eigen::Vector2d& point : points) farthest = std::max(farthest, point.norm());
  return 2. * std::asin(grid.resolution_m() / (2. * farthest));
}

// One search, heading by heading.
class Lattice {
 public:
  Lattice(const submap::ProbabilityGrid& grid, const std::vector<Eigen::Vector2d>& points,
          const PlanarPose& guess, const proto::CorrelativeSearchOptions& options)
      : grid_(grid),
        points_(points),
        guess_(guess),
        options_(options),
        angular_step_rad_(AngularStep(grid, points)),
        max_shift_(static_cast<int>(std::ceil(options.window_m() / grid.resolution_m()))),
        max_turn_(
            static_cast<int>(std::ceil(options.window_deg() * M_PI / 180. / angular_step_rad_))) {}

  int num_headings() const { return 2 * max_turn_ + 1; }

  PlanarPose PoseOf(const Candidate& candidate) const {
    return {guess_.translation + candidate.shift.cast<double>().matrix() * grid_.resolution_m(),
            std::remainder(guess_.yaw_rad + candidate.turn * angular_step_rad_, 2. * M_PI)};
  }

  Candidate BestOfHeading(int heading) const {
    const int turn = heading - max_turn_;
    const int width = 2 * max_shift_ + 1;
    std::vector<double> sums(size_t(width) * width, 0.);
    const Eigen::Rotation2Dd rotation(guess_.yaw_rad + turn * angular_step_rad_);
    for (const Eigen::Vector2d& point : points_) {
      const CellIndex corner = grid_.CellOf(rotation * point + guess_.translation) - max_shift_;
      for (int row = 0; row < width; ++row) {
        double* const sums_of_row = &sums[size_t(row) * width];
        grid_.ForRow({corner.x(), corner.y() + row}, width,
                     [&](int column, float probability) { sums_of_row[column] += probability; });
      }
    }
    Candidate best;
    for (int i = 0; i < width * width; ++i) {
      const CellIndex shift(i % width - max_shift_, i / width - max_shift_);
      const double score = sums[i] / points_.size() * Penalty(shift, turn);
      if (score > best.score) best = {score, shift, turn};
    }
    return best;
  }

 private:
  double Penalty(const CellIndex& shift, int turn) const {
    const double moved_m = shift.cast<double>().matrix().norm() * grid_.resolution_m();
    const double turned_deg = std::abs(turn) * angular_step_rad_ * 180. / M_PI;
    const double translation = options_.translation_penalty_per_m() * moved_m;
    const double rotation = options_.rotation_penalty_per_deg() * turned_deg;
    return std::exp(-translation * translation - rotation * rotation);
  }

  const submap::ProbabilityGrid& grid_;
  const std::vector<Eigen::Vector2d>& points_;
  const PlanarPose guess_;
  const proto::CorrelativeSearchOptions& options_;
  const double angular_step_rad_;
  const int max_shift_;
  const int max_turn_;
};

}  // namespace

PlanarPose SearchAround(const submap::ProbabilityGrid& grid,
                        const std::vector<Eigen::Vector2d>& points,
                        const PlanarPose& grid_from_guess,
                        const proto::CorrelativeSearchOptions& options) {
  if (points.empty()) return grid_from_guess;
  const std::vector<Eigen::Vector2d> kept = Thin(points, options.max_points());
  const Lattice lattice(grid, kept, grid_from_guess, options);
  Candidate best;
  for (const Candidate& candidate : common::ParallelMapChunks<Candidate>(
           lattice.num_headings(), 1,
           [&](size_t begin, size_t) { return lattice.BestOfHeading(static_cast<int>(begin)); })) {
    if (candidate.score > best.score) best = candidate;
  }
  return lattice.PoseOf(best);
}

}  // namespace cartographer::scan_matching
