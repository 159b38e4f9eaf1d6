// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_REMOVE_TRAJECTORIES_H_
#define CARTOGRAPHER_MAP_REMOVE_TRAJECTORIES_H_

#include <cstdint>
#include <set>

#include "cartographer/map/map.h"

namespace cartographer::map {

// What trajectories consist of.
struct ElementCount {
  int64_t nodes = 0;
  int64_t submaps = 0;
  int64_t constraints = 0;
};

// Removes trajectories as a whole: their nodes, their submaps, and every constraint of one of
// these. The ids of the others stay as they are. Returns what is gone.
ElementCount RemoveTrajectories(const std::set<int>& ids, Map* map);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_REMOVE_TRAJECTORIES_H_
