// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_JOIN_GROUPS_H_
#define CARTOGRAPHER_POSE_GRAPH_JOIN_GROUPS_H_

#include "cartographer/pose_graph/graph.h"
#include "cartographer/submap/constraint.h"

namespace cartographer::pose_graph {

// Makes room for the first closure between two groups of trajectories that nothing tied so far, and
// which may be anywhere relative to each other: moves one of them as a whole, upright, so that the
// node is where the closure wants it. The one that moves has no frozen trajectory; if neither has,
// it is the one whose smallest id is larger. Does nothing, and returns false, if the two are tied
// already or both are frozen. The closure's node and submap must be in the graph (CHECKed); the
// closure itself must not be among its constraints yet.
bool JoinGroups(const submap::Constraint& closure, Graph* graph);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_JOIN_GROUPS_H_
