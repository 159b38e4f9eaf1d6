// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_trajectories.h"

#include <algorithm>

namespace cartographer::map {
namespace {

template <typename Elements>
int64_t Remove(const std::set<int>& ids, Elements* elements) {
  const size_t before = elements->size();
  for (auto it = elements->begin(); it != elements->end();) {
    it = ids.count(it->first.trajectory_id) > 0 ? elements->erase(it) : std::next(it);
  }
  return static_cast<int64_t>(before - elements->size());
}

}  // namespace

ElementCount RemoveTrajectories(const std::set<int>& ids, Map* map) {
  ElementCount gone;
  gone.nodes = Remove(ids, &map->nodes);
  gone.submaps = Remove(ids, &map->submaps);
  std::vector<Constraint>& all = map->constraints;
  const auto kept_end = std::remove_if(all.begin(), all.end(), [&ids](const Constraint& c) {
    return ids.count(c.node_id.trajectory_id) > 0 || ids.count(c.submap_id.trajectory_id) > 0;
  });
  gone.constraints = all.end() - kept_end;
  all.erase(kept_end, all.end());
  return gone;
}

}  // namespace cartographer::map
