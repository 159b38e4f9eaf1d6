// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RECORD_READER_H_
#define CARTOGRAPHER_IO_RECORD_READER_H_

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/common/parallel.h"
#include "cartographer/common/status.h"

namespace cartographer::io {

// A record as it stands in the file.
struct CompressedRecord {
  int number = 0;       // from 0
  uint64_t offset = 0;  // of its size field, in bytes from the start of the file
  std::string member;   // gzip

  // "record 3 at byte 1234"
  std::string Name() const;
  // The serialized message.
  absl::StatusOr<std::string> Decompress() const;
};

// Reads a file of records (record_format.h) one by one. Nothing in the file is trusted: a size is
// compared with what is left of the file before memory is taken for it, and all records together
// may decompress to no more than 64 MiB plus 200 times the file's size. Errors name file, record
// and offset.
class RecordReader {
 public:
  // kNotFound if there is no such file, kDataLoss if it does not start with the magic number.
  static absl::StatusOr<RecordReader> Open(const std::string& path);

  // nullopt at the end of the file.
  absl::StatusOr<std::optional<CompressedRecord>> Next();

  const std::string& path() const { return path_; }
  uint64_t file_size() const { return file_size_; }

 private:
  RecordReader(std::string path, std::ifstream stream, uint64_t file_size);
  absl::Status ReadBytes(size_t size, char* bytes);
  absl::Status CheckSize(uint64_t size, const CompressedRecord& record) const;

  std::string path_;
  std::ifstream stream_;
  uint64_t file_size_;
  uint64_t position_ = 0;
  uint64_t decompressed_budget_;
  int num_records_ = 0;
};

// Calls decode(record), which returns an absl::StatusOr, for all remaining records, in parallel and
// a bounded number at a time, then consume(record, value) for each, in order. Stops at the first
// error in the file's order, to which file, record and offset are added.
template <typename Decode, typename Consume>
absl::Status ForEachRecord(RecordReader* reader, const Decode& decode, const Consume& consume) {
  constexpr size_t kMaxRecords = 32;
  constexpr size_t kMaxBytes = size_t{8} << 20;
  using Decoded = std::invoke_result_t<Decode, const CompressedRecord&>;
  bool at_end = false;
  while (!at_end) {
    std::vector<CompressedRecord> batch;
    absl::Status read_status;
    for (size_t bytes = 0; batch.size() < kMaxRecords && bytes < kMaxBytes;) {
      absl::StatusOr<std::optional<CompressedRecord>> record = reader->Next();
      read_status = record.status();
      at_end = !record.ok() || !record->has_value();
      if (at_end) break;
      bytes += (*record)->member.size();
      batch.push_back(**std::move(record));
    }
    std::vector<std::optional<Decoded>> decoded(batch.size());
    common::ParallelChunks(batch.size(), 1,
                           [&](size_t i, size_t) { decoded[i].emplace(decode(batch[i])); });
    for (size_t i = 0; i < batch.size(); ++i) {
      absl::Status status = decoded[i]->status();
      if (status.ok()) status = consume(batch[i], **std::move(decoded[i]));
      RETURN_IF_ERROR(
          common::AddContext(common::AddContext(status, batch[i].Name()), reader->path()));
    }
    RETURN_IF_ERROR(read_status);
  }
  return absl::OkStatus();
}

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RECORD_READER_H_
