// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_REGION_H_
#define CARTOGRAPHER_MAP_REGION_H_

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/map/proto/filter_options.pb.h"

namespace cartographer::map {

// A part of the map's x-y plane; heights play no part. A region without corners is all of it.
//
// Points on the border: those on the lower and left edges of a box are inside, those on the others
// outside, so that boxes side by side share no point; of polygons likewise, up to rounding.
class Region {
 public:
  Region() = default;

  // From `polygon`, `box` and `outside` of the options. Errors, naming option and remedy: both a
  // polygon and a box, an odd count of numbers, fewer than three corners, numbers that are not
  // finite, a box that is not four numbers or has no area, `outside` of nothing.
  static absl::StatusOr<Region> Create(const proto::FilterOptions& options);

  bool IsEverywhere() const { return corners_.empty(); }
  bool Contains(const Eigen::Vector2d& position_m) const;

 private:
  bool Encloses(const Eigen::Vector2d& position_m) const;

  std::vector<Eigen::Vector2d> corners_;
  // Of the corners.
  Eigen::Array2d min_ = Eigen::Array2d::Zero(), max_ = Eigen::Array2d::Zero();
  bool outside_ = false;
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_REGION_H_
