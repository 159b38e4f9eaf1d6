// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_SMALL_MAP_H_
#define TEST_TESTING_SMALL_MAP_H_

#include <random>

#include "cartographer/map/map.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss_testing {

// unlabeled 0, road 1 (ground), car 2 (movable), building 3, pole 4 (critical).
cartographer::sensor::LabelSet StreetLabels();

// Somewhere within 100 m, in any direction, tilted by a few degrees.
cartographer::transform::Rigid3d RandomPose(std::mt19937* random);

// A made-up map, always the same, in which every number differs from its neighbours: with
// StreetLabels(), `nodes_per_trajectory` nodes, from node 3 on, and a submap for every two of them
// in each of the trajectories 1 and 4; the clouds of 4 have intensities and times. Points lie
// within `max_range_m`; a submap has twice as many as a node.
cartographer::map::Map SmallMap(int nodes_per_trajectory, int points_per_node,
                                float max_range_m = 30.f);

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_SMALL_MAP_H_
