// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_reader.h"

#include <memory>
#include <utility>

#include "cartographer/common/status.h"
#include "cartographer/io/map_stream.h"

namespace cartographer::io {
namespace {

using mapping::proto::SerializedData;

absl::Status AddRecord(MapStream::Record record, const PoseGraph& pose_graph, const MapParts& parts,
                       map::Map* map) {
  if (record.kind == SerializedData::kSubmap && (parts.grids || parts.submap_clouds)) {
    ASSIGN_OR_RETURN(SubmapElement element, std::move(record.submap));
    map->submaps[element.id] = {pose_graph.map_from_submap.at(element.id),
                                std::move(element.submap)};
  } else if (record.kind == SerializedData::kNode && parts.node_clouds) {
    NodeElement& element = record.node;
    map->nodes[element.id] = {element.time, pose_graph.nodes.at(element.id).map_from_node,
                              element.local_from_node, std::move(element.cloud)};
  }
  return absl::OkStatus();
}

void AddNodesWithoutClouds(const PoseGraph& pose_graph, map::Map* map) {
  const auto no_points = std::make_shared<const sensor::LabeledPointCloud>();
  for (const auto& [id, node] : pose_graph.nodes) {
    map->nodes[id] = {node.time, node.map_from_node, transform::Rigid3d(), no_points};
  }
}

}  // namespace

absl::StatusOr<map::Map> ReadMap(const std::string& path) { return ReadMapParts(path, {}); }

absl::StatusOr<map::Map> ReadMapParts(const std::string& path, const MapParts& parts) {
  ASSIGN_OR_RETURN(MapStream stream, MapStream::Open(path, parts));
  map::Map map;
  RETURN_IF_ERROR(stream.ForEach([&](MapStream::Record record) {
    return AddRecord(std::move(record), stream.pose_graph(), parts, &map);
  }));
  if (!parts.node_clouds) AddNodesWithoutClouds(stream.pose_graph(), &map);
  map.constraints = stream.pose_graph().constraints;
  map.labels = stream.header().labels;
  map.configuration_lua = stream.header().configuration_lua;
  map.history = stream.header().history;
  return map;
}

}  // namespace cartographer::io
