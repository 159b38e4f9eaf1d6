// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_POSE_GRAPH_PROTO_H_
#define CARTOGRAPHER_IO_POSE_GRAPH_PROTO_H_

#include <map>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/time.h"
#include "cartographer/map/map.h"
#include "cartographer/mapping/proto/pose_graph.pb.h"
#include "cartographer/mapping/proto/trajectory_builder_options.pb.h"
#include "cartographer/submap/id.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

// What a file says about its map before submaps and nodes come: which there are, where they are
// and what ties them.
struct PoseGraph {
  struct Node {
    common::Time time;
    transform::Rigid3d map_from_node;
  };
  std::vector<int> trajectory_ids;  // ascending
  std::map<submap::SubmapId, transform::Rigid3d> map_from_submap;
  std::map<submap::NodeId, Node> nodes;
  std::vector<map::Constraint> constraints;
};

mapping::proto::PoseGraph ToProto(const map::Map& map);

// Errors name the element: negative ids, ids twice, poses that are none, nodes of a trajectory
// whose times decrease, constraints with unknown ids or weights that are negative or not finite,
// two intra-submap constraints between the same node and submap.
absl::StatusOr<PoseGraph> FromProto(const mapping::proto::PoseGraph& proto);

// Cartographer wants an entry for each trajectory, in the order of the pose graph.
mapping::proto::AllTrajectoryBuilderOptions OptionsFor(const mapping::proto::PoseGraph& pose_graph);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_POSE_GRAPH_PROTO_H_
