// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_writer.h"

#include <vector>

#include "cartographer/common/status.h"
#include "cartographer/io/element_proto.h"
#include "cartographer/io/pose_graph_proto.h"
#include "cartographer/io/record_writer.h"

namespace cartographer::io {
namespace {

using mapping::proto::SerializedData;

constexpr int kFormatVersion = 2;

mapping::proto::SerializationHeader Header(const map::Map& map) {
  mapping::proto::SerializationHeader header;
  header.set_format_version(kFormatVersion);
  map::proto::MapDescription& description = *header.mutable_description();
  if (map.labels.declaration().classes_size() > 0) {
    *description.mutable_labels() = map.labels.declaration();
  }
  description.set_configuration_lua(map.configuration_lua);
  for (const std::string& line : map.history) description.add_history(line);
  return header;
}

absl::Status WritePoseGraph(const map::Map& map, const std::string& path, RecordWriter* writer) {
  SerializedData pose_graph;
  *pose_graph.mutable_pose_graph() = ToProto(map);
  // What readers would refuse must not be written.
  RETURN_IF_ERROR(common::AddContext(FromProto(pose_graph.pose_graph()).status(), path));
  RETURN_IF_ERROR(writer->Write(pose_graph));
  SerializedData options;
  *options.mutable_all_trajectory_builder_options() = OptionsFor(pose_graph.pose_graph());
  return writer->Write(options);
}

absl::Status WriteSubmaps(const map::Map& map, RecordWriter* writer) {
  std::vector<SubmapElement> elements;
  for (const auto& [id, submap] : map.submaps) elements.push_back({id, submap.submap});
  return writer->Write<SerializedData>(
      elements.size(), [&](size_t i) -> absl::StatusOr<SerializedData> {
        SerializedData data;
        ASSIGN_OR_RETURN(*data.mutable_submap(), ToProto(elements[i], map.labels));
        return data;
      });
}

absl::Status WriteNodes(const map::Map& map, RecordWriter* writer) {
  std::vector<NodeElement> elements;
  for (const auto& [id, node] : map.nodes) {
    elements.push_back({id, node.time, node.local_from_node, node.cloud});
  }
  return writer->Write<SerializedData>(
      elements.size(), [&](size_t i) -> absl::StatusOr<SerializedData> {
        SerializedData data;
        ASSIGN_OR_RETURN(*data.mutable_node(), ToProto(elements[i], map.labels));
        return data;
      });
}

}  // namespace

absl::Status WriteMap(const map::Map& map, const Destination& destination) {
  ASSIGN_OR_RETURN(RecordWriter writer, RecordWriter::Create(destination));
  RETURN_IF_ERROR(writer.Write(Header(map)));
  RETURN_IF_ERROR(WritePoseGraph(map, destination.path, &writer));
  RETURN_IF_ERROR(WriteSubmaps(map, &writer));
  RETURN_IF_ERROR(WriteNodes(map, &writer));
  return writer.Commit();
}

}  // namespace cartographer::io
