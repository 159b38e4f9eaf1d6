// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_stream.h"

#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/parse_message.h"
#include "cartographer/io/pose_proto.h"
#include "cartographer/io/record_format.h"
#include "google/protobuf/wire_format_lite.h"

namespace cartographer::io {
namespace {

using mapping::proto::SerializedData;

MapStream::RecordSize SizeOf(const CompressedRecord& compressed, const std::string& message) {
  return {compressed.member.size() + kSizeBytes, message.size()};
}

// Whether a serialized record is a submap or a node, by the field that it begins with, which is its
// only one; DATA_NOT_SET for all else. Nothing is parsed.
SerializedData::DataCase ElementKindOf(const std::string& bytes) {
  for (const auto kind : {SerializedData::kSubmap, SerializedData::kNode}) {
    const auto tag = google::protobuf::internal::WireFormatLite::MakeTag(
        kind, google::protobuf::internal::WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
    if (!bytes.empty() && static_cast<uint8_t>(bytes[0]) == tag) return kind;
  }
  return SerializedData::DATA_NOT_SET;
}

// Remembers that an element came. `listed` is what the pose graph has.
template <typename Id, typename Listed>
absl::Status CheckId(const Id& id, const Listed& listed, std::set<Id>* seen) {
  if (listed.count(id) == 0) {
    return absl::DataLossError(absl::StrCat(Name(id), " is not listed in the pose graph"));
  }
  if (seen->insert(id).second) return absl::OkStatus();
  return absl::DataLossError(absl::StrCat(Name(id), " comes twice"));
}

template <typename Id, typename Listed>
absl::Status CheckAllSeen(const Listed& listed, const std::set<Id>& seen) {
  if (seen.size() == listed.size()) return absl::OkStatus();
  for (const auto& [id, unused] : listed) {
    if (seen.count(id) > 0) continue;
    return absl::DataLossError(
        absl::StrCat("the file ends before ", Name(id), ", which its pose graph lists"));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<MapStream> MapStream::Open(const std::string& path, const MapParts& parts) {
  ASSIGN_OR_RETURN(RecordReader reader, RecordReader::Open(path));
  MapStream stream(std::move(reader), parts);
  RETURN_IF_ERROR(stream.ReadOpening());
  return stream;
}

absl::Status MapStream::ReadOpening() {
  RETURN_IF_ERROR(ReadHeader());
  SerializedData data;
  RETURN_IF_ERROR(ReadMessage("pose graph", &data));
  absl::StatusOr<PoseGraph> pose_graph =
      absl::DataLossError("the second record is not the pose graph");
  if (data.has_pose_graph()) pose_graph = FromProto(data.pose_graph());
  RETURN_IF_ERROR(common::AddContext(pose_graph.status(), reader_.path()));
  pose_graph_ = *std::move(pose_graph);
  RETURN_IF_ERROR(ReadMessage("options of trajectories", &data));
  const int num_options = data.all_trajectory_builder_options().options_with_sensor_ids_size();
  if (!data.has_all_trajectory_builder_options() ||
      num_options != pose_graph_.trajectory_ids.size()) {
    return absl::DataLossError(
        absl::StrCat(reader_.path(), ": the third record does not hold options for each of the ",
                     pose_graph_.trajectory_ids.size(), " trajectories"));
  }
  return absl::OkStatus();
}

absl::Status MapStream::ReadMessage(const char* what, google::protobuf::Message* message) {
  ASSIGN_OR_RETURN(const std::optional<CompressedRecord> record, reader_.Next());
  if (!record.has_value()) {
    return absl::DataLossError(
        absl::StrCat(reader_.path(), ": the file ends before the record of the ", what));
  }
  absl::StatusOr<std::string> bytes = record->Decompress();
  const absl::Status status = bytes.ok() ? ParseMessage(*bytes, message) : bytes.status();
  RETURN_IF_ERROR(common::AddContext(common::AddContext(status, record->Name()), reader_.path()));
  opening_sizes_.push_back(SizeOf(*record, *bytes));
  return absl::OkStatus();
}

absl::Status MapStream::ReadHeader() {
  mapping::proto::SerializationHeader proto;
  RETURN_IF_ERROR(ReadMessage("header", &proto));
  header_.format_version = static_cast<int>(proto.format_version());
  if (header_.format_version != 1 && header_.format_version != 2) {
    return absl::UnimplementedError(absl::StrCat(reader_.path(), ": its format version ",
                                                 proto.format_version(), " is not 1 or 2"));
  }
  header_.has_description = proto.has_description();
  const map::proto::MapDescription& description = proto.description();
  if (description.has_labels()) {
    absl::StatusOr<sensor::LabelSet> labels = sensor::LabelSet::Create(description.labels());
    RETURN_IF_ERROR(
        common::AddContext(common::AddContext(labels.status(), "label set"), reader_.path()));
    header_.labels = *std::move(labels);
  }
  header_.configuration_lua = description.configuration_lua();
  header_.history.assign(description.history().begin(), description.history().end());
  return absl::OkStatus();
}

bool MapStream::IsRead(SerializedData::DataCase kind) const {
  if (kind == SerializedData::kSubmap) return parts_.grids || parts_.submap_clouds;
  return kind != SerializedData::kNode || parts_.node_clouds;
}

absl::StatusOr<MapStream::Record> MapStream::Decode(const CompressedRecord& compressed) const {
  ASSIGN_OR_RETURN(const std::string bytes, compressed.Decompress());
  Record record;
  record.kind = ElementKindOf(bytes);
  record.size = SizeOf(compressed, bytes);
  if (!IsRead(record.kind)) return record;
  SerializedData data;
  RETURN_IF_ERROR(ParseMessage(bytes, &data));
  record.kind = data.data_case();
  if (record.kind == SerializedData::kSubmap) {
    record.submap = FromProto(data.submap(), header_.labels, parts_);
    if (!absl::IsUnimplemented(record.submap.status())) {
      RETURN_IF_ERROR(record.submap.status());
    }
  } else if (record.kind == SerializedData::kNode) {
    ASSIGN_OR_RETURN(record.node, FromProto(data.node(), header_.labels));
  } else if (record.kind == SerializedData::kPoseGraph ||
             record.kind == SerializedData::kAllTrajectoryBuilderOptions) {
    return absl::DataLossError("is a second pose graph or a second set of options");
  }
  return record;
}

absl::Status MapStream::CheckListed(const Record& record) {
  if (!IsRead(record.kind)) return absl::OkStatus();
  if (record.kind == SerializedData::kSubmap && record.submap.ok()) {
    return CheckId(record.submap->id, pose_graph_.map_from_submap, &seen_submaps_);
  }
  if (record.kind != SerializedData::kNode) return absl::OkStatus();
  RETURN_IF_ERROR(CheckId(record.node.id, pose_graph_.nodes, &seen_nodes_));
  if (pose_graph_.nodes.at(record.node.id).time == record.node.time) return absl::OkStatus();
  return absl::DataLossError(
      absl::StrCat(Name(record.node.id), " has another time stamp than in the pose graph"));
}

absl::Status MapStream::CheckComplete() const {
  if (IsRead(SerializedData::kSubmap)) {
    RETURN_IF_ERROR(CheckAllSeen(pose_graph_.map_from_submap, seen_submaps_));
  }
  if (!IsRead(SerializedData::kNode)) return absl::OkStatus();
  return CheckAllSeen(pose_graph_.nodes, seen_nodes_);
}

absl::Status MapStream::ForEach(const std::function<absl::Status(Record)>& consume) {
  bool all_supported = true;
  RETURN_IF_ERROR(ForEachRecord(
      &reader_, [this](const CompressedRecord& compressed) { return Decode(compressed); },
      [&](const CompressedRecord&, Record record) -> absl::Status {
        RETURN_IF_ERROR(CheckListed(record));
        all_supported &=
            record.kind != SerializedData::kSubmap || !IsRead(record.kind) || record.submap.ok();
        return consume(std::move(record));
      }));
  return all_supported ? common::AddContext(CheckComplete(), reader_.path()) : absl::OkStatus();
}

}  // namespace cartographer::io
