// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_POSE_GRAPH_PLACE_SCENES_H_
#define TEST_CARTOGRAPHER_POSE_GRAPH_PLACE_SCENES_H_

#include <string>

#include "cartographer/pose_graph/place_descriptor.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// A label set that the program brings along.
sensor::LabelSet ShippedLabels(const std::string& name = "semantic_kitti");

// The shipped options, after `changes` in Lua to the table PLACE_RECOGNITION.
proto::PlaceRecognitionOptions ShippedPlaceOptions(const std::string& changes = "");

PlaceDescriber ShippedDescriber();

// A stretch of street, 120 m long about the origin, that no other seed has: houses and hedges
// beside a road, trees and poles. `day` decides on the parked cars alone.
sensor::LabeledPointCloud Street(int seed, int day = 0);

// The cloud with a share of its labels replaced by others, in blocks of 2 m.
sensor::LabeledPointCloud WithWrongLabels(const sensor::LabeledPointCloud& cloud, double share,
                                          int seed);

}  // namespace cartographer::pose_graph

#endif  // TEST_CARTOGRAPHER_POSE_GRAPH_PLACE_SCENES_H_
