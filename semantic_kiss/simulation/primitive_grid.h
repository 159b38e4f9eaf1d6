// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_PRIMITIVE_GRID_H_
#define SEMANTIC_KISS_SIMULATION_PRIMITIVE_GRID_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/floor.h"
#include "semantic_kiss/simulation/primitive.h"

namespace semantic_kiss::simulation {

// A piece of the plane that opens from a point: what lies ahead, between two lines.
struct Wedge {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  Eigen::Vector2d heading = Eigen::Vector2d::UnitX();  // unit
  // The lines drift to the left of the heading by this a metre ahead; right <= left, |.| < 1.
  double left = 0., right = 0.;
  double reach_m = 0.;  // ahead

  Eigen::Vector2d LeftEdge() const { return Edge(left); }
  Eigen::Vector2d RightEdge() const { return Edge(right); }
  // Not of unit length: advances by a metre ahead.
  Eigen::Vector2d Edge(double drift) const {
    return heading + drift * Eigen::Vector2d(-heading.y(), heading.x());
  }
};

// Finds the primitives that a wedge may touch: a uniform grid of square cells in the plane, each
// with the primitives that touch it.
class PrimitiveGrid {
 public:
  // Keeps copies of nothing: cells hold indices into `primitives`.
  explicit PrimitiveGrid(const std::vector<Primitive>& primitives);

  // Calls visit(index) for the primitives of the cells that the wedge touches; a primitive may be
  // visited more than once.
  template <typename Visit>
  void ForEachIn(const Wedge& wedge, const Visit& visit) const;

  // The same for the square of half-side `reach_m` around a point.
  template <typename Visit>
  void ForEachAround(const Eigen::Vector2d& point, double reach_m, const Visit& visit) const;

 private:
  static constexpr double kCell_m = 2.5;

  // Visits the cells first..last, both included, of line `line`: along x if lines_are_rows, else
  // along y.
  template <typename Visit>
  void ForEachOnLine(bool lines_are_rows, int64_t line, int64_t first, int64_t last,
                     const Visit& visit) const;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<uint32_t> cell_begin_;  // one more than cells
  std::vector<uint32_t> indices_;
};

template <typename Visit>
void PrimitiveGrid::ForEachOnLine(bool lines_are_rows, int64_t line, int64_t first, int64_t last,
                                  const Visit& visit) const {
  if (line < 0 || line >= (lines_are_rows ? rows_ : columns_)) return;
  first = std::max<int64_t>(first, 0);
  last = std::min<int64_t>(last, (lines_are_rows ? columns_ : rows_) - 1);
  const int64_t stride = lines_are_rows ? 1 : columns_;
  const int64_t start = lines_are_rows ? line * columns_ : line;
  for (int64_t cell = start + first * stride; first <= last; ++first, cell += stride) {
    for (uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) visit(indices_[i]);
  }
}

template <typename Visit>
void PrimitiveGrid::ForEachIn(const Wedge& wedge, const Visit& visit) const {
  // Line by line along the axis nearest to the heading, what is between the edges.
  const int major = std::abs(wedge.heading.x()) > std::abs(wedge.heading.y()) ? 0 : 1;
  const int minor = 1 - major;
  const int step = wedge.heading[major] > 0. ? 1 : -1;
  const Eigen::Vector2d tip = (wedge.tip - origin_) / kCell_m;
  const Eigen::Vector2d left = wedge.LeftEdge(), right = wedge.RightEdge();
  // Way across a line for a line ahead.
  const double left_slope = left[minor] / std::abs(left[major]);
  const double right_slope = right[minor] / std::abs(right[major]);
  const int64_t first = Floor(tip[major]);
  const double to_first = step > 0 ? static_cast<double>(first) - tip[major]
                                   : tip[major] - static_cast<double>(first + 1);
  const double reach =
      wedge.reach_m / kCell_m * std::max(std::abs(left[major]), std::abs(right[major]));
  int64_t line = first;
  for (double enter = to_first; enter < reach; enter += 1., line += step) {
    const double begin = std::max(0., enter), end = enter + 1.;
    const auto across =
        std::minmax({begin * left_slope, begin * right_slope, end * left_slope, end * right_slope});
    ForEachOnLine(major == 1, line, Floor(tip[minor] + across.first),
                  Floor(tip[minor] + across.second), visit);
  }
}

template <typename Visit>
void PrimitiveGrid::ForEachAround(const Eigen::Vector2d& point, double reach_m,
                                  const Visit& visit) const {
  const Eigen::Vector2d centre = (point - origin_) / kCell_m;
  const double reach = reach_m / kCell_m;
  for (int64_t row = Floor(centre.y() - reach); row <= Floor(centre.y() + reach); ++row) {
    ForEachOnLine(true, row, Floor(centre.x() - reach), Floor(centre.x() + reach), visit);
  }
}

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_PRIMITIVE_GRID_H_
