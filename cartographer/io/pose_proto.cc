// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/pose_proto.h"

#include <cmath>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace cartographer::io {
namespace {

constexpr double kMaxNormError = 1e-3;
// Products of unit quaternions stay within this; such rotations must not change when read.
constexpr double kRoundOff = 1e-14;

}  // namespace

transform::proto::Quaterniond ToProto(const Eigen::Quaterniond& rotation) {
  transform::proto::Quaterniond proto;
  proto.set_x(rotation.x());
  proto.set_y(rotation.y());
  proto.set_z(rotation.z());
  proto.set_w(rotation.w());
  return proto;
}

transform::proto::Rigid3d ToProto(const transform::Rigid3d& pose) {
  transform::proto::Rigid3d proto;
  proto.mutable_translation()->set_x(pose.translation().x());
  proto.mutable_translation()->set_y(pose.translation().y());
  proto.mutable_translation()->set_z(pose.translation().z());
  *proto.mutable_rotation() = ToProto(pose.rotation());
  return proto;
}

mapping::proto::SubmapId ToProto(const submap::SubmapId& id) {
  mapping::proto::SubmapId proto;
  proto.set_trajectory_id(id.trajectory_id);
  proto.set_submap_index(id.submap_index);
  return proto;
}

mapping::proto::NodeId ToProto(const submap::NodeId& id) {
  mapping::proto::NodeId proto;
  proto.set_trajectory_id(id.trajectory_id);
  proto.set_node_index(id.node_index);
  return proto;
}

absl::StatusOr<Eigen::Quaterniond> FromProto(const transform::proto::Quaterniond& proto) {
  const Eigen::Quaterniond rotation(proto.w(), proto.x(), proto.y(), proto.z());
  const double norm_error = std::abs(rotation.norm() - 1.);
  // Written so that NaN fails, too.
  if (!(norm_error <= kMaxNormError)) {
    return absl::DataLossError(absl::StrCat("the rotation (w, x, y, z) = (", proto.w(), ", ",
                                            proto.x(), ", ", proto.y(), ", ", proto.z(),
                                            ") is no unit quaternion"));
  }
  return norm_error <= kRoundOff ? rotation : rotation.normalized();
}

absl::StatusOr<transform::Rigid3d> FromProto(const transform::proto::Rigid3d& proto) {
  const Eigen::Vector3d translation(proto.translation().x(), proto.translation().y(),
                                    proto.translation().z());
  if (!translation.allFinite()) {
    return absl::DataLossError(absl::StrCat("the translation (", translation.x(), ", ",
                                            translation.y(), ", ", translation.z(),
                                            ") is not finite"));
  }
  ASSIGN_OR_RETURN(const Eigen::Quaterniond rotation, FromProto(proto.rotation()));
  return transform::Rigid3d::FromUnitRotation(translation, rotation);
}

std::string Name(const submap::SubmapId& id) {
  return absl::StrCat("submap (", id.trajectory_id, ", ", id.submap_index, ")");
}

std::string Name(const submap::NodeId& id) {
  return absl::StrCat("node (", id.trajectory_id, ", ", id.node_index, ")");
}

}  // namespace cartographer::io
