// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/primitive_grid.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace semantic_kiss::simulation {
namespace {

// Whether a primitive, seen from above, comes within `reach` of a point.
bool Touches(const Primitive& primitive, const Eigen::Vector2d& point, double reach) {
  const Eigen::Vector2d offset = point - primitive.centre.head<2>();
  if (primitive.shape == Shape::kCylinder) return offset.norm() <= primitive.half.x() + reach;
  const Eigen::Vector3d local = primitive.ToLocal(Eigen::Vector3d(offset.x(), offset.y(), 0.));
  const Eigen::Array2d beyond =
      (local.head<2>().array().abs() - primitive.half.head<2>().array()).max(0.);
  return beyond.matrix().norm() <= reach;
}

}  // namespace

PrimitiveGrid::PrimitiveGrid(const std::vector<Primitive>& primitives) {
  Eigen::AlignedBox2d bounds(Eigen::Vector2d::Zero());
  for (const Primitive& primitive : primitives) {
    const Eigen::Vector2d radius = Eigen::Vector2d::Constant(primitive.PlanarRadius());
    bounds.extend(primitive.centre.head<2>() - radius);
    bounds.extend(primitive.centre.head<2>() + radius);
  }
  origin_ = bounds.min();
  columns_ = static_cast<int>(bounds.sizes().x() / kCell_m) + 1;
  rows_ = static_cast<int>(bounds.sizes().y() / kCell_m) + 1;
  const size_t cells = static_cast<size_t>(columns_) * rows_;
  cell_begin_.assign(cells + 1, 0);

  const auto for_each_cell = [&](const Primitive& primitive, const auto& body) {
    const double radius = primitive.PlanarRadius();
    const Eigen::Vector2d centre = (primitive.centre.head<2>() - origin_) / kCell_m;
    const double reach = radius / kCell_m;
    for (int j = std::max(0, static_cast<int>(centre.y() - reach));
         j <= std::min<int>(rows_ - 1, static_cast<int>(centre.y() + reach)); ++j) {
      for (int i = std::max(0, static_cast<int>(centre.x() - reach));
           i <= std::min<int>(columns_ - 1, static_cast<int>(centre.x() + reach)); ++i) {
        const Eigen::Vector2d middle = origin_ + kCell_m * Eigen::Vector2d(i + 0.5, j + 0.5);
        if (Touches(primitive, middle, 0.71 * kCell_m)) {
          body(static_cast<size_t>(j) * columns_ + i);
        }
      }
    }
  };
  for (const Primitive& primitive : primitives) {
    for_each_cell(primitive, [&](size_t cell) { ++cell_begin_[cell + 1]; });
  }
  for (size_t i = 0; i < cells; ++i) cell_begin_[i + 1] += cell_begin_[i];
  indices_.resize(cell_begin_.back());
  std::vector<uint32_t> cursor(cell_begin_.begin(), cell_begin_.end() - 1);
  for (uint32_t index = 0; index < primitives.size(); ++index) {
    for_each_cell(primitives[index], [&](size_t cell) { indices_[cursor[cell]++] = index; });
  }
}

}  // namespace semantic_kiss::simulation
