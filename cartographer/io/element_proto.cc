// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/element_proto.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/cloud_proto.h"
#include "cartographer/io/pose_proto.h"
#include "cartographer/io/semantic_grid_proto.h"
#include "cartographer/io/stock_grid.h"

namespace cartographer::io {
namespace {

absl::StatusOr<mapping::proto::Submap> UnnamedToProto(const SubmapElement& element,
                                                      const sensor::LabelSet& labels) {
  const submap::Submap& submap = *element.submap;
  mapping::proto::Submap proto;
  *proto.mutable_submap_id() = ToProto(element.id);
  mapping::proto::Submap2D& stock = *proto.mutable_submap_2d();
  *stock.mutable_local_pose() = ToProto(submap.local_from_submap);
  stock.set_num_range_data(submap.num_scans);
  stock.set_finished(submap.finished);
  // First, since it checks that cells are where indices can be computed with.
  map::proto::SemanticSubmap& semantic = *proto.mutable_semantic();
  ASSIGN_OR_RETURN(*semantic.mutable_grid(), ToProto(submap.grid, labels.size()));
  ASSIGN_OR_RETURN(*stock.mutable_grid(),
                   ToStockGrid(submap.grid, labels.WithRole(sensor::LabelRole::kGround),
                               submap.local_from_submap));
  ASSIGN_OR_RETURN(CloudProto cloud,
                   ToProto(submap.cloud, labels.size(), Eigen::Quaterniond::Identity()));
  *semantic.mutable_cloud() = std::move(cloud.positions);
  *semantic.mutable_cloud_attributes() = std::move(cloud.attributes);
  return proto;
}

absl::StatusOr<submap::SemanticGrid> GridFromProto(const mapping::proto::Submap& proto,
                                                   const transform::Rigid3d& local_from_submap,
                                                   const sensor::LabelSet& labels,
                                                   const MapParts& parts) {
  constexpr double kAnyResolution_m = 1.;
  if (!parts.grids) return submap::SemanticGrid(kAnyResolution_m);
  if (proto.has_semantic()) return FromProto(proto.semantic().grid(), labels.size());
  return FromStockGrid(proto.submap_2d().grid(), local_from_submap);
}

absl::StatusOr<SubmapElement> UnnamedFromProto(const mapping::proto::Submap& proto,
                                               const sensor::LabelSet& labels,
                                               const MapParts& parts) {
  if (!proto.has_submap_2d()) {
    return absl::UnimplementedError("is not 2D; only 2D maps of Cartographer can be opened");
  }
  const mapping::proto::Submap2D& stock = proto.submap_2d();
  if (stock.num_range_data() < 0) {
    return absl::DataLossError(absl::StrCat("has ", stock.num_range_data(), " scans"));
  }
  ASSIGN_OR_RETURN(const transform::Rigid3d local_from_submap, FromProto(stock.local_pose()));
  ASSIGN_OR_RETURN(submap::SemanticGrid grid,
                   GridFromProto(proto, local_from_submap, labels, parts));
  auto submap = std::make_shared<submap::Submap>(grid.resolution_m());
  submap->local_from_submap = local_from_submap;
  submap->grid = std::move(grid);
  submap->num_scans = stock.num_range_data();
  submap->finished = stock.finished();
  if (proto.has_semantic() && parts.submap_clouds) {
    ASSIGN_OR_RETURN(submap->cloud,
                     FromProto(proto.semantic().cloud(), &proto.semantic().cloud_attributes(),
                               labels.size(), Eigen::Quaterniond::Identity()));
  }
  return SubmapElement{FromProto(proto.submap_id()), std::move(submap)};
}

// The rotation from the sensor to a level frame with the same heading, in which Cartographer
// keeps clouds.
Eigen::Quaterniond GravityAlignment(const transform::Rigid3d& local_from_node) {
  return transform::Level(local_from_node).rotation().conjugate() * local_from_node.rotation();
}

absl::StatusOr<mapping::proto::Node> UnnamedToProto(const NodeElement& element,
                                                    const sensor::LabelSet& labels) {
  mapping::proto::Node proto;
  *proto.mutable_node_id() = ToProto(element.id);
  mapping::proto::TrajectoryNodeData& data = *proto.mutable_node_data();
  data.set_timestamp(common::ToUniversal(element.time));
  *data.mutable_local_pose() = ToProto(element.local_from_node);
  const Eigen::Quaterniond level_from_node = GravityAlignment(element.local_from_node);
  *data.mutable_gravity_alignment() = ToProto(level_from_node);
  ASSIGN_OR_RETURN(CloudProto cloud, ToProto(*element.cloud, labels.size(), level_from_node));
  *data.mutable_filtered_gravity_aligned_point_cloud() = std::move(cloud.positions);
  *proto.mutable_point_attributes() = std::move(cloud.attributes);
  return proto;
}

absl::StatusOr<NodeElement> UnnamedFromProto(const mapping::proto::Node& proto,
                                             const sensor::LabelSet& labels) {
  const mapping::proto::TrajectoryNodeData& data = proto.node_data();
  NodeElement element;
  element.id = FromProto(proto.node_id());
  element.time = common::FromUniversal(data.timestamp());
  ASSIGN_OR_RETURN(element.local_from_node, FromProto(data.local_pose()));
  ASSIGN_OR_RETURN(const Eigen::Quaterniond level_from_node, FromProto(data.gravity_alignment()));
  ASSIGN_OR_RETURN(sensor::LabeledPointCloud cloud,
                   FromProto(data.filtered_gravity_aligned_point_cloud(),
                             proto.has_point_attributes() ? &proto.point_attributes() : nullptr,
                             labels.size(), level_from_node));
  element.cloud = std::make_shared<const sensor::LabeledPointCloud>(std::move(cloud));
  return element;
}

// Adds the element's name to an error.
template <typename Result, typename Id>
absl::StatusOr<Result> Named(absl::StatusOr<Result> result, const Id& id) {
  if (result.ok()) return result;
  return common::AddContext(result.status(), Name(id));
}

}  // namespace

absl::StatusOr<mapping::proto::Submap> ToProto(const SubmapElement& element,
                                               const sensor::LabelSet& labels) {
  return Named(UnnamedToProto(element, labels), element.id);
}

absl::StatusOr<mapping::proto::Node> ToProto(const NodeElement& element,
                                             const sensor::LabelSet& labels) {
  return Named(UnnamedToProto(element, labels), element.id);
}

absl::StatusOr<SubmapElement> FromProto(const mapping::proto::Submap& proto,
                                        const sensor::LabelSet& labels, const MapParts& parts) {
  return Named(UnnamedFromProto(proto, labels, parts), FromProto(proto.submap_id()));
}

absl::StatusOr<NodeElement> FromProto(const mapping::proto::Node& proto,
                                      const sensor::LabelSet& labels) {
  return Named(UnnamedFromProto(proto, labels), FromProto(proto.node_id()));
}

}  // namespace cartographer::io
