// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RECORD_WRITER_H_
#define CARTOGRAPHER_IO_RECORD_WRITER_H_

#include <functional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/io/atomic_file.h"
#include "google/protobuf/message_lite.h"

namespace cartographer::io {

// Writes a file of records (record_format.h), atomically.
class RecordWriter {
 public:
  static absl::StatusOr<RecordWriter> Create(const Destination& destination);

  // Writes the messages make(0), ..., make(count - 1) as records in this order. Calls of `make`
  // run in parallel, as does compression; about a message a thread is in memory at a time. Errors
  // name the file; a message over kMaxMessageSize is one.
  template <typename Message>
  absl::Status Write(size_t count, const std::function<absl::StatusOr<Message>(size_t)>& make) {
    return WriteCompressed(count, [&make](size_t i) -> absl::StatusOr<std::string> {
      const absl::StatusOr<Message> message = make(i);
      if (!message.ok()) return message.status();
      return Compress(*message);
    });
  }

  absl::Status Write(const google::protobuf::MessageLite& message);

  absl::Status Commit() { return file_.Commit(); }

 private:
  RecordWriter(std::string path, AtomicFile file)
      : path_(std::move(path)), file_(std::move(file)) {}

  static absl::StatusOr<std::string> Compress(const google::protobuf::MessageLite& message);
  absl::Status WriteCompressed(size_t count,
                               const std::function<absl::StatusOr<std::string>(size_t)>& make);
  absl::Status WriteInteger(uint64_t value);

  std::string path_;
  AtomicFile file_;
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RECORD_WRITER_H_
