// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_trajectory.h"

#include <map>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"
#include "cartographer/io/map_stream.h"

namespace cartographer::io {

absl::StatusOr<MapTrajectory> ReadMapTrajectory(const std::string& map_path,
                                                std::optional<int> id) {
  MapParts nothing;
  nothing.grids = nothing.submap_clouds = nothing.node_clouds = false;
  ASSIGN_OR_RETURN(const MapStream stream, MapStream::Open(map_path, nothing));
  std::map<int, MapTrajectory> trajectories;
  for (const auto& [node_id, node] : stream.pose_graph().nodes) {
    MapTrajectory& trajectory = trajectories[node_id.trajectory_id];
    trajectory.times.push_back(node.time);
    trajectory.map_from_sensor.push_back(node.map_from_node);
  }
  std::vector<int> ids;
  for (const auto& [known_id, trajectory] : trajectories) ids.push_back(known_id);
  if (ids.empty()) return absl::NotFoundError(absl::StrCat(map_path, ": the map has no nodes"));
  if (!id.has_value() && ids.size() > 1) {
    return absl::InvalidArgumentError(
        absl::StrCat(map_path, ": the map has several trajectories: ", absl::StrJoin(ids, ", "),
                     "; choose one of them"));
  }
  const auto chosen = trajectories.find(id.value_or(ids.front()));
  if (chosen != trajectories.end()) return std::move(chosen->second);
  return absl::NotFoundError(absl::StrCat(map_path, ": the map has no trajectory ", *id,
                                          " with nodes; it has ", absl::StrJoin(ids, ", ")));
}

}  // namespace cartographer::io
