// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_POSE_PROTO_H_
#define CARTOGRAPHER_IO_POSE_PROTO_H_

#include <string>

#include "absl/status/statusor.h"
#include "cartographer/mapping/proto/pose_graph.pb.h"
#include "cartographer/submap/id.h"
#include "cartographer/transform/proto/transform.pb.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

transform::proto::Rigid3d ToProto(const transform::Rigid3d& pose);
transform::proto::Quaterniond ToProto(const Eigen::Quaterniond& rotation);
mapping::proto::SubmapId ToProto(const submap::SubmapId& id);
mapping::proto::NodeId ToProto(const submap::NodeId& id);

// Errors: numbers that are not finite, a quaternion whose norm is off 1 by over 1e-3. What
// ToProto() wrote comes back bit by bit.
absl::StatusOr<transform::Rigid3d> FromProto(const transform::proto::Rigid3d& proto);
absl::StatusOr<Eigen::Quaterniond> FromProto(const transform::proto::Quaterniond& proto);

inline submap::SubmapId FromProto(const mapping::proto::SubmapId& proto) {
  return {proto.trajectory_id(), proto.submap_index()};
}
inline submap::NodeId FromProto(const mapping::proto::NodeId& proto) {
  return {proto.trajectory_id(), proto.node_index()};
}

// For errors: "submap (0, 12)", "node (0, 345)".
std::string Name(const submap::SubmapId& id);
std::string Name(const submap::NodeId& id);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_POSE_PROTO_H_
