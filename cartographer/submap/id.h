// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_ID_H_
#define CARTOGRAPHER_SUBMAP_ID_H_

#include <tuple>

namespace cartographer::submap {

// A trajectory is one drive; its nodes and submaps count from 0.
struct NodeId {
  int trajectory_id = 0;
  int node_index = 0;
};

struct SubmapId {
  int trajectory_id = 0;
  int submap_index = 0;
};

inline bool operator<(const NodeId& a, const NodeId& b) {
  return std::tie(a.trajectory_id, a.node_index) < std::tie(b.trajectory_id, b.node_index);
}
inline bool operator==(const NodeId& a, const NodeId& b) {
  return a.trajectory_id == b.trajectory_id && a.node_index == b.node_index;
}
inline bool operator<(const SubmapId& a, const SubmapId& b) {
  return std::tie(a.trajectory_id, a.submap_index) < std::tie(b.trajectory_id, b.submap_index);
}
inline bool operator==(const SubmapId& a, const SubmapId& b) {
  return a.trajectory_id == b.trajectory_id && a.submap_index == b.submap_index;
}

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_ID_H_
