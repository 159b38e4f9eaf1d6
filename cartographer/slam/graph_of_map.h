// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_GRAPH_OF_MAP_H_
#define CARTOGRAPHER_SLAM_GRAPH_OF_MAP_H_

#include <set>

#include "cartographer/map/map.h"
#include "cartographer/pose_graph/graph.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::slam {

// A finished map as what a pose graph may go on with. Nothing is copied but poses and constraints.
pose_graph::Graph GraphOf(const map::Map& map);

// The same with all of its trajectories frozen. What their odometry said is of no interest any
// more, and not known if the map was read without node clouds: their local frames are the map's.
pose_graph::Graph FrozenGraphOf(const map::Map& map);

// The way back; configuration and history are left to the caller.
map::Map MapOf(pose_graph::Graph graph, const sensor::LabelSet& labels);

// The smallest number that is larger than those of all trajectories; 0 for an empty map.
int NextTrajectoryId(const map::Map& map);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_GRAPH_OF_MAP_H_
