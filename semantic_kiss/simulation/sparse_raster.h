// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SPARSE_RASTER_H_
#define SEMANTIC_KISS_SIMULATION_SPARSE_RASTER_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "glog/logging.h"
#include "semantic_kiss/simulation/floor.h"

namespace semantic_kiss::simulation {

// Values at the nodes of a square lattice in the plane, stored only in the tiles (64 x 64 nodes)
// that were written. Node (i, j) lies at (i, j) * step; nodes that were never written read as
// `absent`. Nodes outside of the bounds may be read but not written.
template <typename T>
class SparseRaster {
 public:
  static constexpr int kTile = 64;

  SparseRaster(const Eigen::AlignedBox2d& bounds, double step, const T& absent)
      : step_(step), per_step_(1. / step), absent_(absent) {
    first_tile_x_ = TileOf(Node(bounds.min().x()));
    first_tile_y_ = TileOf(Node(bounds.min().y()));
    tiles_x_ = TileOf(Node(bounds.max().x()) + 1) - first_tile_x_ + 1;
    tiles_y_ = TileOf(Node(bounds.max().y()) + 1) - first_tile_y_ + 1;
    tiles_.resize(static_cast<size_t>(tiles_x_) * tiles_y_);
  }

  double step() const { return step_; }
  // The node at or below a coordinate [m].
  int Node(double coordinate) const { return static_cast<int>(Floor(coordinate * per_step_)); }

  const T& At(int i, int j) const {
    const std::vector<T>* tile = FindTile(i, j);
    return tile == nullptr || tile->empty() ? absent_ : (*tile)[Offset(i, j)];
  }

  // CHECK-fails outside of the bounds.
  T& MutableAt(int i, int j) {
    std::vector<T>* tile = const_cast<std::vector<T>*>(FindTile(i, j));
    CHECK(tile != nullptr);
    if (tile->empty()) tile->assign(kTile * kTile, absent_);
    return (*tile)[Offset(i, j)];
  }

  // The four nodes around a point, and where the point lies between them (both in [0, 1)):
  // values of (i, j), (i+1, j), (i, j+1), (i+1, j+1).
  struct Patch {
    std::array<const T*, 4> corners;
    double u, v;
  };
  Patch PatchAt(double x, double y) const {
    const double scaled_x = x * per_step_;
    const double scaled_y = y * per_step_;
    const int i = static_cast<int>(Floor(scaled_x));
    const int j = static_cast<int>(Floor(scaled_y));
    Patch patch;
    patch.u = scaled_x - i;
    patch.v = scaled_y - j;
    if (((i + 1) & (kTile - 1)) != 0 && ((j + 1) & (kTile - 1)) != 0) {
      // All in one tile.
      const std::vector<T>* tile = FindTile(i, j);
      if (tile == nullptr || tile->empty()) {
        patch.corners = {&absent_, &absent_, &absent_, &absent_};
        return patch;
      }
      const T* low = tile->data() + Offset(i, j);
      patch.corners = {low, low + 1, low + kTile, low + kTile + 1};
      return patch;
    }
    patch.corners = {&At(i, j), &At(i + 1, j), &At(i, j + 1), &At(i + 1, j + 1)};
    return patch;
  }

  // Calls body(tile's first i, tile's first j) for all written tiles, in a fixed order.
  template <typename Body>
  void ForEachTile(const Body& body) const {
    for (size_t k = 0; k < tiles_.size(); ++k) {
      if (tiles_[k].empty()) continue;
      body((first_tile_x_ + static_cast<int>(k % tiles_x_)) * kTile,
           (first_tile_y_ + static_cast<int>(k / tiles_x_)) * kTile);
    }
  }

 private:
  static int TileOf(int node) { return node >> 6; }
  static size_t Offset(int i, int j) {
    return static_cast<size_t>(j & (kTile - 1)) * kTile + (i & (kTile - 1));
  }
  const std::vector<T>* FindTile(int i, int j) const {
    const int x = TileOf(i) - first_tile_x_;
    const int y = TileOf(j) - first_tile_y_;
    if (x < 0 || y < 0 || x >= tiles_x_ || y >= tiles_y_) return nullptr;
    return &tiles_[static_cast<size_t>(y) * tiles_x_ + x];
  }

  double step_, per_step_;
  T absent_;
  int first_tile_x_, first_tile_y_, tiles_x_, tiles_y_;
  std::vector<std::vector<T>> tiles_;
};

// The value between four nodes.
template <typename Patch>
double Bilinear(const Patch& patch, double a, double b, double c, double d) {
  return (a * (1. - patch.u) + b * patch.u) * (1. - patch.v) +
         (c * (1. - patch.u) + d * patch.u) * patch.v;
}

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SPARSE_RASTER_H_
