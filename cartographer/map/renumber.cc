// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/renumber.h"

#include <utility>

namespace cartographer::map {
namespace {

template <typename Id, typename Value>
std::map<Id, Value> Renumbered(std::map<Id, Value> entries, int offset) {
  std::map<Id, Value> renumbered;
  for (auto& [id, value] : entries) {
    Id moved = id;
    moved.trajectory_id += offset;
    renumbered.emplace(moved, std::move(value));
  }
  return renumbered;
}

}  // namespace

Map Renumbered(Map map, int offset) {
  map.submaps = Renumbered(std::move(map.submaps), offset);
  map.nodes = Renumbered(std::move(map.nodes), offset);
  for (Constraint& constraint : map.constraints) {
    constraint.submap_id.trajectory_id += offset;
    constraint.node_id.trajectory_id += offset;
  }
  return map;
}

}  // namespace cartographer::map
