// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/trajectories.h"

namespace cartographer::map {

std::set<int> TrajectoriesOf(const Map& map) {
  std::set<int> ids;
  for (const auto& [id, node] : map.nodes) ids.insert(id.trajectory_id);
  for (const auto& [id, submap] : map.submaps) ids.insert(id.trajectory_id);
  return ids;
}

}  // namespace cartographer::map
