// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_PRIMITIVE_GRID_H_
#define SEMANTIC_KISS_SIMULATION_PRIMITIVE_GRID_H_

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/ray.h"

namespace semantic_kiss::simulation {

// Finds the primitives near a ray: a uniform grid of columns in the plane, each with the primitives
// that touch it and the height of the tallest.
class PrimitiveGrid {
 public:
  // Keeps copies of nothing: cells hold indices into `primitives`.
  explicit PrimitiveGrid(const std::vector<Primitive>& primitives);

  // Calls visit(index, limit) for the primitives of the cells that the ray passes within `limit`,
  // cell by cell in the ray's order; visit returns the new limit, which must not grow. A primitive
  // may be visited more than once.
  template <typename Visit>
  void Walk(const Ray& ray, double limit, const Visit& visit) const;

 private:
  static constexpr double kCell_m = 2.5;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<uint32_t> cell_begin_;  // one more than cells
  std::vector<float> cell_top_m_;
  std::vector<uint32_t> indices_;
};

template <typename Visit>
void PrimitiveGrid::Walk(const Ray& ray, double limit, const Visit& visit) const {
  // Per axis: the cell, its direction of change, and the ray's parameters where it changes.
  const Eigen::Vector2d start = (ray.origin.head<2>() - origin_) / kCell_m;
  int cell[2], step[2];
  double next[2], delta[2];
  for (int axis : {0, 1}) {
    const double d = ray.direction[axis];
    cell[axis] = static_cast<int>(std::floor(start[axis]));
    step[axis] = d > 0. ? 1 : -1;
    delta[axis] = kCell_m / std::max(std::abs(d), 1e-12);
    const double to_edge = d > 0. ? cell[axis] + 1 - start[axis] : start[axis] - cell[axis];
    next[axis] = to_edge * delta[axis];
  }
  double t = 0.;
  while (t < limit) {
    const int axis = next[0] < next[1] ? 0 : 1;
    const double leave = next[axis];
    if (cell[0] >= 0 && cell[1] >= 0 && cell[0] < columns_ && cell[1] < rows_) {
      const size_t k = static_cast<size_t>(cell[1]) * columns_ + cell[0];
      const double lowest =
          ray.origin.z() +
          ray.direction.z() * (ray.direction.z() > 0. ? t : std::min(leave, limit));
      if (lowest <= cell_top_m_[k]) {
        for (uint32_t i = cell_begin_[k]; i < cell_begin_[k + 1]; ++i) {
          limit = visit(indices_[i], limit);
        }
      }
    }
    t = leave;
    next[axis] += delta[axis];
    cell[axis] += step[axis];
  }
}

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_PRIMITIVE_GRID_H_
