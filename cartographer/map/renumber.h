// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_RENUMBER_H_
#define CARTOGRAPHER_MAP_RENUMBER_H_

#include "cartographer/map/map.h"

namespace cartographer::map {

// The map with `offset` added to the numbers of all trajectories.
Map Renumbered(Map map, int offset);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_RENUMBER_H_
