// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_STREAM_H_
#define CARTOGRAPHER_IO_MAP_STREAM_H_

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/io/element_proto.h"
#include "cartographer/io/pose_graph_proto.h"
#include "cartographer/io/record_reader.h"
#include "cartographer/mapping/proto/serialization.pb.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::io {

// A pbstream file (docs/file_formats.md) as a stream: first what describes the map as a whole,
// then its submaps and nodes one after the other, of which only a bounded number is in memory.
// Reads our maps and those of Cartographer.
//
// Everything is checked: the records' order, each element by itself (element_proto.h,
// pose_graph_proto.h), and that exactly the elements of the pose graph come, each once. Errors
// name file, record, offset and element.
class MapStream {
 public:
  struct Header {
    int format_version = 0;
    // Whether the map is of this program; if not, the members below are empty.
    bool has_description = false;
    sensor::LabelSet labels;
    std::string configuration_lua;
    std::vector<std::string> history;
  };

  // What a record costs.
  struct RecordSize {
    uint64_t stored_bytes = 0;  // in the file, with the size field
    uint64_t message_bytes = 0;
  };

  // Submaps, nodes and the records that a map does not keep (IMU, odometry, ...). Of those that
  // hold no part that is read, only kind and size are known.
  struct Record {
    mapping::proto::SerializedData::DataCase kind = mapping::proto::SerializedData::DATA_NOT_SET;
    RecordSize size;
    // Of the kind kSubmap; kUnimplemented for submaps that are not 2D grids of probabilities.
    absl::StatusOr<SubmapElement> submap;
    NodeElement node;  // of the kind kNode
  };

  // Reads the header, the pose graph and the options of trajectories (which only get counted).
  // ForEach() then reads the parts.
  static absl::StatusOr<MapStream> Open(const std::string& path, const MapParts& parts = {});

  const Header& header() const { return header_; }
  const PoseGraph& pose_graph() const { return pose_graph_; }
  // The sizes of the three records that Open() read.
  const std::vector<RecordSize>& opening_sizes() const { return opening_sizes_; }
  uint64_t file_size() const { return reader_.file_size(); }

  // Calls consume for all other records, in the file's order, from the calling thread. Call once.
  absl::Status ForEach(const std::function<absl::Status(Record)>& consume);

 private:
  MapStream(RecordReader reader, const MapParts& parts)
      : reader_(std::move(reader)), parts_(parts) {}

  absl::Status ReadOpening();
  absl::Status ReadMessage(const char* what, google::protobuf::Message* message);
  absl::Status ReadHeader();
  absl::StatusOr<Record> Decode(const CompressedRecord& compressed) const;
  bool IsRead(mapping::proto::SerializedData::DataCase kind) const;
  absl::Status CheckListed(const Record& record);
  absl::Status CheckComplete() const;

  RecordReader reader_;
  MapParts parts_;
  Header header_;
  PoseGraph pose_graph_;
  std::vector<RecordSize> opening_sizes_;
  std::set<submap::SubmapId> seen_submaps_;
  std::set<submap::NodeId> seen_nodes_;
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_STREAM_H_
