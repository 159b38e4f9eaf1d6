// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_HEIGHT_OFFSET_H_
#define CARTOGRAPHER_POSE_GRAPH_HEIGHT_OFFSET_H_

#include <optional>

#include "cartographer/pose_graph/ground_heights.h"
#include "cartographer/pose_graph/proto/verification_options.pb.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

struct HeightOffset {
  double offset_m;  // how far the node must be lifted for its ground to lie on the target's
  int num_points;   // of the node, over known ground
};

// Compares the ground under a node with the target's, at a pose that is right but for its height:
// the median, over the node's ground points, of how far the target's ground is above them. nullopt
// if there are fewer than `options.min_points` such points.
//   cloud             sensor frame
//   ground            labels of the ground
std::optional<HeightOffset> FindHeightOffset(const sensor::LabeledPointCloud& cloud,
                                             const transform::Rigid3d& target_from_node,
                                             const GroundHeights& target,
                                             const sensor::LabelMask& ground,
                                             const proto::GroundOptions& options);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_HEIGHT_OFFSET_H_
