// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_FILTER_SCOPE_H_
#define CARTOGRAPHER_MAP_FILTER_SCOPE_H_

#include <set>

#include "absl/status/statusor.h"
#include "cartographer/map/map.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/map/region.h"

namespace cartographer::map {

// The part of a map that a filter may change.
struct FilterScope {
  Region region;
  std::set<int> trajectories;
  bool all_trajectories = true;  // whether these are all that the map has

  // Errors begin with the option: those of Region::Create(), a trajectory that the map does not
  // have, `keep_trajectories` beside `trajectories`.
  static absl::StatusOr<FilterScope> Create(const proto::FilterOptions& options, const Map& map);

  template <typename Id>
  bool Contains(const Id& id) const {
    return trajectories.count(id.trajectory_id) > 0;
  }
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_FILTER_SCOPE_H_
