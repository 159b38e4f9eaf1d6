// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_ERASE_KEYS_H_
#define CARTOGRAPHER_POSE_GRAPH_ERASE_KEYS_H_

#include <iterator>

namespace cartographer::pose_graph {

// Erases the entries of a std::map whose keys fulfil a predicate.
template <typename Map, typename Predicate>
void EraseKeysIf(Map* map, const Predicate& predicate) {
  for (auto it = map->begin(); it != map->end();) {
    it = predicate(it->first) ? map->erase(it) : std::next(it);
  }
}

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_ERASE_KEYS_H_
