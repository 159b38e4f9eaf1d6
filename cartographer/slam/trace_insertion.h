// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_TRACE_INSERTION_H_
#define CARTOGRAPHER_SLAM_TRACE_INSERTION_H_

#include <string>

#include "cartographer/sensor/label.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/local_trajectory_builder.h"

namespace cartographer::slam {

// What went into submaps, and what became the node's cloud: each with the step that gave it.
struct InsertedPoints {
  const sensor::LabeledPointCloud& into_submaps;
  std::string submaps_from;
  const sensor::LabeledPointCloud& into_node;
  std::string node_from;
  // Left out of both.
  sensor::LabelMask moving;
  // Whether the scan's place is known; else it becomes no node.
  bool placed = true;
};

// Appends what became of a scan after it was placed: a step for each submap that took it, and one
// for its node; or that it became none. `seconds`: what all of it took.
void TraceInsertion(const LocalResult& result, const InsertedPoints& points, double seconds,
                    ScanTrace* trace);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_TRACE_INSERTION_H_
