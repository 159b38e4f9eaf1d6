// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/record_writer.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/parallel.h"
#include "cartographer/common/status.h"
#include "cartographer/io/gzip.h"
#include "cartographer/io/record_format.h"

namespace cartographer::io {
namespace {

// Records that are compressed before they are written: enough to keep the threads busy.
constexpr size_t kBatchSize = 32;

}  // namespace

absl::StatusOr<RecordWriter> RecordWriter::Create(const Destination& destination) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(destination));
  RecordWriter writer(destination.path, std::move(file));
  RETURN_IF_ERROR(writer.WriteInteger(kMagic));
  return writer;
}

absl::Status RecordWriter::Write(const google::protobuf::MessageLite& message) {
  return WriteCompressed(1, [&message](size_t) { return Compress(message); });
}

absl::StatusOr<std::string> RecordWriter::Compress(const google::protobuf::MessageLite& message) {
  const size_t size = message.ByteSizeLong();
  if (size > kMaxMessageSize) {
    return absl::InvalidArgumentError(
        absl::StrCat("a record of ", size, " bytes is over the ", kMaxMessageSize,
                     " that readers take; use smaller submaps or larger cells"));
  }
  return GzipCompress(message.SerializeAsString());
}

absl::Status RecordWriter::WriteCompressed(
    size_t count, const std::function<absl::StatusOr<std::string>(size_t)>& make) {
  for (size_t begin = 0; begin < count; begin += kBatchSize) {
    const size_t size = std::min(kBatchSize, count - begin);
    const auto members = common::ParallelMapChunks<absl::StatusOr<std::string>>(
        size, 1, [&](size_t i, size_t) { return make(begin + i); });
    for (const absl::StatusOr<std::string>& member : members) {
      RETURN_IF_ERROR(common::AddContext(member.status(), path_));
      RETURN_IF_ERROR(WriteInteger(member->size()));
      RETURN_IF_ERROR(file_.Write(*member));
    }
  }
  return absl::OkStatus();
}

absl::Status RecordWriter::WriteInteger(uint64_t value) {
  char bytes[kSizeBytes];
  for (char& byte : bytes) {
    byte = static_cast<char>(value & 0xff);
    value >>= 8;
  }
  return file_.Write(absl::string_view(bytes, kSizeBytes));
}

}  // namespace cartographer::io
