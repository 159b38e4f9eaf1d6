// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_TRAJECTORIES_H_
#define CARTOGRAPHER_MAP_TRAJECTORIES_H_

#include <set>

#include "cartographer/map/map.h"

namespace cartographer::map {

// The trajectories that a map has nodes or submaps of.
std::set<int> TrajectoriesOf(const Map& map);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_TRAJECTORIES_H_
