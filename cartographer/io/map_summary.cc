// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_summary.h"

#include <algorithm>
#include <map>

#include "cartographer/common/status.h"
#include "cartographer/io/map_stream.h"
#include "cartographer/io/submap_bounds.h"
#include "cartographer/mapping/proto/serialization.pb.h"

namespace cartographer::io {
namespace {

using mapping::proto::SerializedData;

// The name of the field of SerializedData that a record fills.
std::string NameOf(SerializedData::DataCase kind) {
  const auto* field = SerializedData::descriptor()->FindFieldByNumber(kind);
  return field == nullptr ? "unknown" : field->name();
}

void CountRecord(const std::string& name, const MapStream::RecordSize& size, MapSummary* summary) {
  auto kind = std::find_if(summary->kinds.begin(), summary->kinds.end(),
                           [&name](const MapSummary::Kind& k) { return k.name == name; });
  if (kind == summary->kinds.end()) {
    kind = summary->kinds.insert(summary->kinds.end(), MapSummary::Kind{name});
  }
  ++kind->count;
  kind->stored_bytes += size.stored_bytes;
  kind->message_bytes += size.message_bytes;
}

void SumUpPoseGraph(const PoseGraph& graph, MapSummary* summary) {
  std::map<int, MapSummary::Trajectory> trajectories;
  for (const int id : graph.trajectory_ids) trajectories[id].id = id;
  std::map<int, Eigen::Vector3d> last_position;
  for (const auto& [id, node] : graph.nodes) {
    MapSummary::Trajectory& trajectory = trajectories[id.trajectory_id];
    const Eigen::Vector3d& position = node.map_from_node.translation();
    if (trajectory.num_nodes++ == 0) {
      trajectory.first_time = node.time;
    } else {
      trajectory.length_m += (position - last_position[id.trajectory_id]).norm();
    }
    trajectory.last_time = node.time;
    last_position[id.trajectory_id] = position;
    summary->node_bounds_m.extend(position);
  }
  for (const auto& [id, pose] : graph.map_from_submap) {
    ++trajectories[id.trajectory_id].num_submaps;
  }
  for (const auto& [id, trajectory] : trajectories) summary->trajectories.push_back(trajectory);
  summary->num_intra_constraints =
      std::count_if(graph.constraints.begin(), graph.constraints.end(), [](const auto& constraint) {
        return constraint.kind == map::Constraint::Kind::kIntraSubmap;
      });
  summary->num_inter_constraints = graph.constraints.size() - summary->num_intra_constraints;
}

void SumUpSubmap(const submap::Submap& submap, const transform::Rigid3d& map_from_submap,
                 MapSummary* summary) {
  map::CountSubmap(submap, &summary->label_counts);
  summary->grid_bounds_m.extend(BoundsInMap(submap.grid, map_from_submap));
}

}  // namespace

absl::StatusOr<MapSummary> ReadMapSummary(const std::string& path) {
  ASSIGN_OR_RETURN(MapStream stream, MapStream::Open(path));
  MapSummary summary;
  summary.file_bytes = stream.file_size();
  summary.format_version = stream.header().format_version;
  summary.made_by_us = stream.header().has_description;
  summary.labels = stream.header().labels;
  summary.configuration_lua = stream.header().configuration_lua;
  summary.history = stream.header().history;
  summary.label_counts.resize(summary.labels.size());
  CountRecord("header", stream.opening_sizes()[0], &summary);
  CountRecord(NameOf(SerializedData::kPoseGraph), stream.opening_sizes()[1], &summary);
  CountRecord(NameOf(SerializedData::kAllTrajectoryBuilderOptions), stream.opening_sizes()[2],
              &summary);
  SumUpPoseGraph(stream.pose_graph(), &summary);
  RETURN_IF_ERROR(stream.ForEach([&](const MapStream::Record& record) {
    CountRecord(NameOf(record.kind), record.size, &summary);
    if (record.kind == SerializedData::kNode) {
      map::CountNode(*record.node.cloud, &summary.label_counts);
    } else if (record.kind == SerializedData::kSubmap && record.submap.ok()) {
      SumUpSubmap(*record.submap->submap, stream.pose_graph().map_from_submap.at(record.submap->id),
                  &summary);
    } else if (record.kind == SerializedData::kSubmap) {
      ++summary.num_unsupported_submaps;
    }
    return absl::OkStatus();
  }));
  return summary;
}

}  // namespace cartographer::io
