// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_cloud.h"

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/hidden_labels.h"
#include "cartographer/io/map_stream.h"

namespace cartographer::io {

using mapping::proto::SerializedData;

absl::StatusOr<MapCloud> MapCloud::Read(const std::string& map_path, CloudSource source,
                                        const proto::RenderOptions& options) {
  MapParts parts;
  parts.grids = false;
  parts.submap_clouds = source == CloudSource::kSubmaps;
  parts.node_clouds = source == CloudSource::kNodes;
  ASSIGN_OR_RETURN(MapStream stream, MapStream::Open(map_path, parts));
  MapCloud result;
  result.labels_ = stream.header().labels;
  if (options.cloud_resolution_m() > 0.) {
    result.points_.emplace<VoxelThinning>(options.cloud_resolution_m());
  }
  ASSIGN_OR_RETURN(const sensor::LabelMask hidden, HiddenLabels(options, result.labels_));
  RETURN_IF_ERROR(stream.ForEach([&](const MapStream::Record& record) -> absl::Status {
    if (record.kind == SerializedData::kSubmap && parts.submap_clouds) {
      RETURN_IF_ERROR(record.submap.status());
      return result.Add(record.submap->submap->cloud,
                        stream.pose_graph().map_from_submap.at(record.submap->id), hidden);
    }
    if (record.kind == SerializedData::kNode && parts.node_clouds) {
      return result.Add(*record.node.cloud,
                        stream.pose_graph().nodes.at(record.node.id).map_from_node, hidden);
    }
    return absl::OkStatus();
  }));
  if (result.size() > 0) return result;
  return absl::FailedPreconditionError(
      absl::StrCat(map_path, ": there are no points to write: no cloud of a ",
                   parts.node_clouds ? "node" : "submap", " has a point of a label that is shown",
                   parts.node_clouds || stream.header().has_description
                       ? ""
                       : "; in maps of Cartographer only the nodes have clouds, so use them"));
}

absl::Status MapCloud::Add(const sensor::LabeledPointCloud& cloud,
                           const transform::Rigid3d& map_from_cloud,
                           const sensor::LabelMask& hidden) {
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (hidden.Contains(cloud.labels[i])) continue;
    const Eigen::Vector3d position = map_from_cloud * cloud.positions[i].cast<double>();
    const bool has_intensity = !cloud.intensities.empty();
    has_intensities_ = has_intensities_ && has_intensity;
    const MapPoint point{position.cast<float>(), cloud.certainties[i],
                         has_intensity ? cloud.intensities[i] : 0.f, cloud.labels[i]};
    if (auto* const points = std::get_if<std::vector<MapPoint>>(&points_)) {
      points->push_back(point);
    } else {
      RETURN_IF_ERROR(std::get<VoxelThinning>(points_).Add(position, point));
    }
  }
  return absl::OkStatus();
}

size_t MapCloud::size() const {
  return std::visit([](const auto& points) { return points.size(); }, points_);
}

MapPoint MapCloud::At(size_t index) const {
  if (const auto* const points = std::get_if<std::vector<MapPoint>>(&points_)) {
    return (*points)[index];
  }
  return std::get<VoxelThinning>(points_).At(index);
}

}  // namespace cartographer::io
