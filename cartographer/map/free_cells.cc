// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/free_cells.h"

#include <cstddef>

namespace cartographer::map {

using submap::CellIndex;

VisitedSquare::VisitedSquare(const CellIndex& min, int side, int reach)
    : side_(side),
      reach_(reach),
      width_(side + 2 * reach),
      min_(min - reach),
      ground_(size_t(width_) * width_),
      standing_(ground_.size()) {}

void VisitedSquare::Add(const CellIndex& cell, int hits, std::vector<uint32_t>* layer) {
  const CellIndex place = cell - min_;
  if ((place < 0).any() || (place >= width_).any()) return;
  (*layer)[size_t(place.y()) * width_ + place.x()] += hits;
}

std::vector<uint64_t> VisitedSquare::SumsWithinReach(const std::vector<uint32_t>& layer) const {
  // integral[y * stride + x] is the sum over all cells before column x in the rows before y.
  const size_t stride = width_ + 1, window = 2 * reach_ + 1;
  std::vector<uint64_t> integral(stride * stride);
  for (size_t y = 0; y + 1 < stride; ++y) {
    uint64_t row_sum = 0;
    for (size_t x = 0; x + 1 < stride; ++x) {
      row_sum += layer[y * width_ + x];
      integral[(y + 1) * stride + x + 1] = integral[y * stride + x + 1] + row_sum;
    }
  }
  std::vector<uint64_t> sums;
  sums.reserve(size_t(side_) * side_);
  for (int y = 0; y < side_; ++y) {
    for (int x = 0; x < side_; ++x) {
      const uint64_t* const lower = &integral[y * stride + x];
      const uint64_t* const upper = lower + window * stride;
      sums.push_back(upper[window] - upper[0] - lower[window] + lower[0]);
    }
  }
  return sums;
}

std::vector<bool> VisitedSquare::FreeCells(const proto::TransientOptions& options) const {
  const std::vector<uint64_t> ground = SumsWithinReach(ground_);
  const std::vector<uint64_t> standing = SumsWithinReach(standing_);
  std::vector<bool> free(ground.size());
  for (size_t i = 0; i < free.size(); ++i) {
    const auto ground_hits = static_cast<double>(ground[i]);
    free[i] = ground_hits >= options.min_ground_hits() &&
              static_cast<double>(standing[i]) <= options.max_movable_share() * ground_hits;
  }
  return free;
}

}  // namespace cartographer::map
