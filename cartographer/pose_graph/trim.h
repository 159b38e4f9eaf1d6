// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_TRIM_H_
#define CARTOGRAPHER_POSE_GRAPH_TRIM_H_

#include "cartographer/pose_graph/graph.h"
#include "cartographer/submap/id.h"

namespace cartographer::pose_graph {

// Removes what a trajectory has before a node: its earlier nodes, the finished submaps that only
// they are in, and all constraints of either. Submaps that still grow stay.
void TrimBefore(const submap::NodeId& first_kept, Graph* graph);

// Removes all of a trajectory.
void RemoveTrajectory(int trajectory_id, Graph* graph);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_TRIM_H_
