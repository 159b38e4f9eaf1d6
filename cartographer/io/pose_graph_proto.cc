// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/pose_graph_proto.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/pose_proto.h"

namespace cartographer::io {
namespace {

// So that further trajectories can be numbered on from it, and maps be joined.
constexpr int kMaxTrajectoryId = 1'000'000'000;

using ProtoConstraint = mapping::proto::PoseGraph::Constraint;

std::map<int, mapping::proto::Trajectory> Trajectories(const map::Map& map) {
  std::map<int, mapping::proto::Trajectory> trajectories;
  for (const auto& [id, node] : map.nodes) {
    auto& proto = *trajectories[id.trajectory_id].add_node();
    proto.set_node_index(id.node_index);
    proto.set_timestamp(common::ToUniversal(node.time));
    *proto.mutable_pose() = ToProto(node.map_from_node);
  }
  for (const auto& [id, submap] : map.submaps) {
    auto& proto = *trajectories[id.trajectory_id].add_submap();
    proto.set_submap_index(id.submap_index);
    *proto.mutable_pose() = ToProto(submap.map_from_submap);
  }
  for (auto& [id, proto] : trajectories) proto.set_trajectory_id(id);
  return trajectories;
}

using Information = Eigen::Matrix<double, 6, 6>;
constexpr int kInformationEntries = 21;

void InformationToProto(const Information& information, ProtoConstraint* proto) {
  for (int row = 0; row < 6; ++row) {
    for (int column = row; column < 6; ++column) {
      proto->add_information(information(row, column));
    }
  }
}

// Absent where the proto has none.
absl::StatusOr<std::optional<Information>> InformationFromProto(const ProtoConstraint& proto) {
  if (proto.information_size() == 0) return std::nullopt;
  if (proto.information_size() != kInformationEntries) {
    return absl::DataLossError(absl::StrCat("its information has ", proto.information_size(),
                                            " entries in place of ", kInformationEntries));
  }
  Information information;
  const double* entry = proto.information().data();
  for (int row = 0; row < 6; ++row) {
    for (int column = row; column < 6; ++column, ++entry) {
      information(row, column) = information(column, row) = *entry;
    }
  }
  // Comparisons with NaN are false.
  if (!information.allFinite() || !(information.ldlt().vectorD().minCoeff() > 0.)) {
    return absl::DataLossError("its information is not a positive definite matrix");
  }
  return information;
}

// What Cartographer gives by default to the constraints that it finds by loop closure. Ours get the
// same where `information` says what we know of them: beside the weights of its own terms, 1 /
// sigma would count for nothing, and its optimization would open our loops again.
constexpr double kLoopTranslationWeight = 1.1e4;
constexpr double kLoopRotationWeight = 1e5;

void WeightsToProto(const map::Constraint& constraint, ProtoConstraint* proto) {
  if (!constraint.information.has_value()) {
    proto->set_translation_weight(constraint.translation_weight);
    proto->set_rotation_weight(constraint.rotation_weight);
    return;
  }
  proto->set_translation_weight(kLoopTranslationWeight);
  proto->set_rotation_weight(kLoopRotationWeight);
  InformationToProto(*constraint.information, proto);
}

ProtoConstraint ConstraintToProto(const map::Constraint& constraint) {
  ProtoConstraint proto;
  *proto.mutable_submap_id() = ToProto(constraint.submap_id);
  *proto.mutable_node_id() = ToProto(constraint.node_id);
  *proto.mutable_relative_pose() = ToProto(constraint.submap_from_node);
  WeightsToProto(constraint, &proto);
  proto.set_tag(constraint.kind == map::Constraint::Kind::kIntraSubmap
                    ? ProtoConstraint::INTRA_SUBMAP
                    : ProtoConstraint::INTER_SUBMAP);
  return proto;
}

// Adds an element whose pose is `proto`; `make` turns the pose into the element.
template <typename Id, typename Element, typename Make>
absl::Status Insert(const Id& id, int index, const transform::proto::Rigid3d& proto,
                    std::map<Id, Element>* elements, const Make& make) {
  if (index < 0) return absl::DataLossError(absl::StrCat(Name(id), " has a negative index"));
  const absl::StatusOr<transform::Rigid3d> pose = FromProto(proto);
  RETURN_IF_ERROR(common::AddContext(pose.status(), Name(id)));
  if (!elements->emplace(id, make(*pose)).second) {
    return absl::DataLossError(absl::StrCat(Name(id), " is listed twice"));
  }
  return absl::OkStatus();
}

absl::Status AddTrajectory(const mapping::proto::Trajectory& proto, PoseGraph* graph) {
  const int id = proto.trajectory_id();
  const auto& ids = graph->trajectory_ids;
  if (id < 0 || std::find(ids.begin(), ids.end(), id) != ids.end()) {
    return absl::DataLossError(absl::StrCat("trajectory ", id, " is listed twice or negative"));
  }
  if (id > kMaxTrajectoryId) {
    return absl::DataLossError(
        absl::StrCat("trajectory ", id, " has a number above ", kMaxTrajectoryId));
  }
  graph->trajectory_ids.push_back(id);
  for (const auto& node : proto.node()) {
    const common::Time time = common::FromUniversal(node.timestamp());
    RETURN_IF_ERROR(Insert(submap::NodeId{id, node.node_index()}, node.node_index(), node.pose(),
                           &graph->nodes, [time](const transform::Rigid3d& pose) {
                             return PoseGraph::Node{time, pose};
                           }));
  }
  for (const auto& submap : proto.submap()) {
    RETURN_IF_ERROR(Insert(submap::SubmapId{id, submap.submap_index()}, submap.submap_index(),
                           submap.pose(), &graph->map_from_submap,
                           [](const transform::Rigid3d& pose) { return pose; }));
  }
  return absl::OkStatus();
}

absl::Status CheckTimes(const PoseGraph& graph) {
  const submap::NodeId* previous = nullptr;
  common::Time previous_time;
  for (const auto& [id, node] : graph.nodes) {
    if (previous != nullptr && previous->trajectory_id == id.trajectory_id &&
        node.time < previous_time) {
      return absl::DataLossError(absl::StrCat(Name(id), " is older than ", Name(*previous)));
    }
    previous = &id;
    previous_time = node.time;
  }
  return absl::OkStatus();
}

absl::StatusOr<map::Constraint> ConstraintFromProto(const ProtoConstraint& proto,
                                                    const PoseGraph& graph) {
  map::Constraint constraint;
  constraint.submap_id = FromProto(proto.submap_id());
  constraint.node_id = FromProto(proto.node_id());
  if (graph.map_from_submap.count(constraint.submap_id) == 0) {
    return absl::DataLossError(absl::StrCat(Name(constraint.submap_id), " does not exist"));
  }
  if (graph.nodes.count(constraint.node_id) == 0) {
    return absl::DataLossError(absl::StrCat(Name(constraint.node_id), " does not exist"));
  }
  ASSIGN_OR_RETURN(constraint.submap_from_node, FromProto(proto.relative_pose()));
  constraint.translation_weight = proto.translation_weight();
  constraint.rotation_weight = proto.rotation_weight();
  const double weights[] = {constraint.translation_weight, constraint.rotation_weight};
  for (const double weight : weights) {
    if (std::isfinite(weight) && weight >= 0.) continue;
    return absl::DataLossError(absl::StrCat("the weight ", weight, " is negative or not finite"));
  }
  ASSIGN_OR_RETURN(constraint.information, InformationFromProto(proto));
  if (proto.tag() != ProtoConstraint::INTRA_SUBMAP &&
      proto.tag() != ProtoConstraint::INTER_SUBMAP) {
    return absl::DataLossError(absl::StrCat("unknown kind ", static_cast<int>(proto.tag())));
  }
  constraint.kind = proto.tag() == ProtoConstraint::INTRA_SUBMAP
                        ? map::Constraint::Kind::kIntraSubmap
                        : map::Constraint::Kind::kInterSubmap;
  if (constraint.kind == map::Constraint::Kind::kIntraSubmap &&
      constraint.node_id.trajectory_id != constraint.submap_id.trajectory_id) {
    return absl::DataLossError(absl::StrCat(Name(constraint.node_id), " cannot be in ",
                                            Name(constraint.submap_id),
                                            ", which is of another trajectory"));
  }
  return constraint;
}

absl::Status AddConstraints(const mapping::proto::PoseGraph& proto, PoseGraph* graph) {
  std::set<std::pair<submap::SubmapId, submap::NodeId>> members;
  graph->constraints.reserve(proto.constraint_size());
  for (const ProtoConstraint& constraint_proto : proto.constraint()) {
    absl::StatusOr<map::Constraint> constraint = ConstraintFromProto(constraint_proto, *graph);
    if (constraint.ok() && constraint->kind == map::Constraint::Kind::kIntraSubmap &&
        !members.emplace(constraint->submap_id, constraint->node_id).second) {
      constraint = absl::DataLossError(absl::StrCat(Name(constraint->node_id), " is in ",
                                                    Name(constraint->submap_id), " twice"));
    }
    RETURN_IF_ERROR(common::AddContext(constraint.status(),
                                       absl::StrCat("constraint ", graph->constraints.size())));
    graph->constraints.push_back(*std::move(constraint));
  }
  return absl::OkStatus();
}

}  // namespace

mapping::proto::PoseGraph ToProto(const map::Map& map) {
  mapping::proto::PoseGraph proto;
  for (const map::Constraint& constraint : map.constraints) {
    *proto.add_constraint() = ConstraintToProto(constraint);
  }
  for (auto& [id, trajectory] : Trajectories(map)) *proto.add_trajectory() = std::move(trajectory);
  return proto;
}

absl::StatusOr<PoseGraph> FromProto(const mapping::proto::PoseGraph& proto) {
  PoseGraph graph;
  for (const mapping::proto::Trajectory& trajectory : proto.trajectory()) {
    RETURN_IF_ERROR(AddTrajectory(trajectory, &graph));
  }
  std::sort(graph.trajectory_ids.begin(), graph.trajectory_ids.end());
  RETURN_IF_ERROR(CheckTimes(graph));
  RETURN_IF_ERROR(AddConstraints(proto, &graph));
  return graph;
}

mapping::proto::AllTrajectoryBuilderOptions OptionsFor(
    const mapping::proto::PoseGraph& pose_graph) {
  mapping::proto::AllTrajectoryBuilderOptions options;
  for (int i = 0; i < pose_graph.trajectory_size(); ++i) {
    mapping::proto::SensorId& sensor = *options.add_options_with_sensor_ids()->add_sensor_id();
    sensor.set_type(mapping::proto::SensorId::RANGE);
    sensor.set_id("lidar");
  }
  return options;
}

}  // namespace cartographer::io
