// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/region.h"

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace cartographer::map {
namespace {

using Numbers = google::protobuf::RepeatedField<double>;
using Corners = std::vector<Eigen::Vector2d>;

absl::Status CheckFinite(const char* option, const Numbers& numbers) {
  for (int i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i])) continue;
    return absl::InvalidArgumentError(
        absl::StrCat(option, ": number ", i + 1, " is ", numbers[i], "; give metres"));
  }
  return absl::OkStatus();
}

absl::StatusOr<Corners> CornersOfPolygon(const Numbers& numbers) {
  RETURN_IF_ERROR(CheckFinite("polygon", numbers));
  if (numbers.size() % 2 != 0) {
    return absl::InvalidArgumentError(absl::StrCat("polygon: has ", numbers.size(),
                                                   " numbers, the last corner lacks its y; give "
                                                   "x1,y1,x2,y2,..."));
  }
  if (numbers.size() < 6) {
    return absl::InvalidArgumentError(absl::StrCat("polygon: has ", numbers.size() / 2,
                                                   " corners; give at least 3, as "
                                                   "x1,y1,x2,y2,x3,y3"));
  }
  Corners corners;
  for (int i = 0; i < numbers.size(); i += 2) corners.emplace_back(numbers[i], numbers[i + 1]);
  return corners;
}

absl::StatusOr<Corners> CornersOfBox(const Numbers& numbers) {
  RETURN_IF_ERROR(CheckFinite("box", numbers));
  if (numbers.size() != 4) {
    return absl::InvalidArgumentError(
        absl::StrCat("box: has ", numbers.size(), " numbers; give 4, x_min,y_min,x_max,y_max"));
  }
  const Eigen::Vector2d min(numbers[0], numbers[1]), max(numbers[2], numbers[3]);
  if (!(min.array() < max.array()).all()) {
    return absl::InvalidArgumentError(absl::StrCat("box: from (", min.x(), ", ", min.y(), ") to (",
                                                   max.x(), ", ", max.y(),
                                                   ") has no area; give x_min,y_min,x_max,y_max"));
  }
  return Corners{min, {max.x(), min.y()}, max, {min.x(), max.y()}};
}

}  // namespace

absl::StatusOr<Region> Region::Create(const proto::FilterOptions& options) {
  const bool has_polygon = !options.polygon().empty(), has_box = !options.box().empty();
  if (has_polygon && has_box) {
    return absl::InvalidArgumentError("polygon: there is a box as well; give one of the two");
  }
  Region region;
  if (!has_polygon && !has_box) {
    if (!options.outside()) return region;
    return absl::InvalidArgumentError("outside: of what? give a polygon or a box as well");
  }
  if (has_polygon) {
    ASSIGN_OR_RETURN(region.corners_, CornersOfPolygon(options.polygon()));
  } else {
    ASSIGN_OR_RETURN(region.corners_, CornersOfBox(options.box()));
  }
  region.min_ = region.max_ = region.corners_.front();
  for (const Eigen::Vector2d& corner : region.corners_) {
    region.min_ = region.min_.min(corner.array());
    region.max_ = region.max_.max(corner.array());
  }
  region.outside_ = options.outside();
  return region;
}

bool Region::Contains(const Eigen::Vector2d& position_m) const {
  return IsEverywhere() || Encloses(position_m) != outside_;
}

bool Region::Encloses(const Eigen::Vector2d& position_m) const {
  if ((position_m.array() < min_).any() || (position_m.array() >= max_).any()) return false;
  // How often the lines cross the ray from the position along x: an odd number of times inside.
  bool inside = false;
  const Eigen::Vector2d* previous = &corners_.back();
  for (const Eigen::Vector2d& corner : corners_) {
    const bool spans = (corner.y() > position_m.y()) != (previous->y() > position_m.y());
    if (spans) {
      const double share = (position_m.y() - corner.y()) / (previous->y() - corner.y());
      const double crossing_x = corner.x() + share * (previous->x() - corner.x());
      if (position_m.x() < crossing_x) inside = !inside;
    }
    previous = &corner;
  }
  return inside;
}

}  // namespace cartographer::map
