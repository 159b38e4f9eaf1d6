// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_PROBABILITY_GRID_H_
#define CARTOGRAPHER_SUBMAP_PROBABILITY_GRID_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cartographer/submap/proto/planar_submap_options.pb.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::submap {

// A dense grid of the probabilities that cells of the x-y plane are occupied, for builders that do
// not know what they see. Where a scan's points fall, the odds of being occupied rise, once a scan
// however many they are; along the rays to them, the odds fall. Probabilities stay within
// [kMinProbability, kMaxProbability], so that a cell can change its mind.
// Source: Hess et al., "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016, section IV-B.
class ProbabilityGrid {
 public:
  static constexpr double kMinProbability = 0.1;
  static constexpr double kMaxProbability = 0.9;

  explicit ProbabilityGrid(const proto::ProbabilityGridOptions& options);

  double resolution_m() const { return resolution_m_; }
  CellIndex CellOf(const Eigen::Vector2d& position) const {
    return (position / resolution_m_).array().floor().cast<int>();
  }

  // Adds a scan taken at `origin` that hit `points`, both in the grid's frame [m], finite; none
  // tell nothing. Of rays that are less than a cell apart all the way only the longest is cast: it
  // passes through the cells of the others as well.
  void InsertScan(const Eigen::Vector2d& origin, const std::vector<Eigen::Vector2d>& points);

  bool IsKnown(const CellIndex& cell) const { return LogOddsOf(cell) != kUnknown; }
  // P(occupied); kMinProbability for what is not known.
  float Probability(const CellIndex& cell) const { return ProbabilityOf(LogOddsOf(cell)); }

  // How many hits, and nothing else, would make a cell as likely to be occupied as it is; 0 if it
  // is rather free or not known.
  int EquivalentHits(const CellIndex& cell) const;

  // The box of cells outside of which nothing is known.
  const SemanticGrid::CellBox& bounds() const { return box_; }

  // Calls visit(column, probability) for the `width` cells from `first` on along x.
  template <typename Visit>
  void ForRow(const CellIndex& first, int width, const Visit& visit) const {
    const bool inside = first.y() >= box_.min.y() && first.y() < box_.max.y() &&
                        first.x() >= box_.min.x() && first.x() + width <= box_.max.x();
    if (inside) {
      const Cell* const cells = &cells_[OffsetOf(first)];
      for (int i = 0; i < width; ++i) visit(i, ProbabilityOf(cells[i].log_odds));
    } else {
      for (int i = 0; i < width; ++i) visit(i, Probability({first.x() + i, first.y()}));
    }
  }

 private:
  // In thousandths, rounded.
  using LogOdds = int16_t;
  static constexpr LogOdds kUnknown = INT16_MIN;
  // log(kMaxProbability / (1 - kMaxProbability)) = -log(kMinProbability / ...).
  static constexpr LogOdds kMaxLogOdds = 2197;

  struct Cell {
    LogOdds log_odds = kUnknown;
    uint16_t last_scan = 0;  // that changed it
  };

  static LogOdds ToLogOdds(double probability);
  float ProbabilityOf(LogOdds log_odds) const {
    return log_odds == kUnknown ? static_cast<float>(kMinProbability)
                                : probabilities_[log_odds + kMaxLogOdds];
  }
  LogOdds LogOddsOf(const CellIndex& cell) const {
    if ((cell < box_.min).any() || (cell >= box_.max).any()) return kUnknown;
    return cells_[OffsetOf(cell)].log_odds;
  }
  size_t OffsetOf(const CellIndex& cell) const {
    return size_t(cell.y() - box_.min.y()) * (box_.max.x() - box_.min.x()) +
           (cell.x() - box_.min.x());
  }

  // Makes room for a box of cells.
  void Grow(const SemanticGrid::CellBox& box);
  void BeginScan();
  // Changes a cell unless this scan did already; whether it did so now.
  bool Update(LogOdds change, Cell* cell) const;
  // Lowers the odds of the cells between those of two places, the last one excluded; in cells.
  void CastRay(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  double resolution_m_;
  LogOdds hit_;
  LogOdds miss_;
  bool cast_rays_;
  std::vector<float> probabilities_;  // by log odds + kMaxLogOdds
  SemanticGrid::CellBox box_;
  std::vector<Cell> cells_;  // row by row
  uint16_t scan_ = 0;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_PROBABILITY_GRID_H_
