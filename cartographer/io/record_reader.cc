// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/record_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "cartographer/io/gzip.h"
#include "cartographer/io/record_format.h"

namespace cartographer::io {
namespace {

// What all records of a file may decompress to. Dense grids, mostly unknown, are what expands most
// in honest files: less than 50 times.
constexpr uint64_t kMaxTotalRatio = 200;

uint64_t LittleEndian(const char* bytes) {
  uint64_t value = 0;
  for (size_t i = kSizeBytes; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

absl::StatusOr<uint64_t> SizeOfFile(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    return absl::NotFoundError(absl::StrCat(path, ": no such file"));
  }
  if (!std::filesystem::is_regular_file(status)) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": is not a regular file"));
  }
  const uint64_t size = std::filesystem::file_size(path, error);
  if (error) return absl::UnavailableError(absl::StrCat(path, ": ", error.message()));
  return size;
}

}  // namespace

std::string CompressedRecord::Name() const {
  return absl::StrCat("record ", number, " at byte ", offset);
}

absl::StatusOr<std::string> CompressedRecord::Decompress() const {
  return GzipDecompress(member, kMaxMessageSize);
}

RecordReader::RecordReader(std::string path, std::ifstream stream, uint64_t file_size)
    : path_(std::move(path)),
      stream_(std::move(stream)),
      file_size_(file_size),
      decompressed_budget_(kMaxMessageSize + kMaxTotalRatio * file_size) {}

absl::StatusOr<RecordReader> RecordReader::Open(const std::string& path) {
  ASSIGN_OR_RETURN(const uint64_t file_size, SizeOfFile(path));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return absl::PermissionDeniedError(
        absl::StrCat(path, ": cannot open for reading: ", std::strerror(errno)));
  }
  RecordReader reader(path, std::move(stream), file_size);
  char magic[kSizeBytes] = {};
  if (file_size < kSizeBytes || !reader.ReadBytes(kSizeBytes, magic).ok() ||
      LittleEndian(magic) != kMagic) {
    return absl::DataLossError(
        absl::StrCat(path, ": is not a pbstream file: it does not start with the magic number"));
  }
  return reader;
}

absl::StatusOr<std::optional<CompressedRecord>> RecordReader::Next() {
  if (position_ == file_size_) return std::optional<CompressedRecord>();
  CompressedRecord record;
  record.number = num_records_++;
  record.offset = position_;
  char size_bytes[kSizeBytes] = {};
  RETURN_IF_ERROR(CheckSize(kSizeBytes, record));
  RETURN_IF_ERROR(ReadBytes(kSizeBytes, size_bytes));
  const uint64_t size = LittleEndian(size_bytes);
  RETURN_IF_ERROR(CheckSize(size, record));
  record.member.resize(size);
  RETURN_IF_ERROR(ReadBytes(size, record.member.data()));

  const uint64_t decompressed_size = GzipClaimedSize(record.member);
  if (decompressed_size > decompressed_budget_) {
    return absl::DataLossError(absl::StrCat(path_, ": ", record.Name(), ": the records so far ",
                                            "decompress to over ", kMaxTotalRatio,
                                            " times the file's size"));
  }
  decompressed_budget_ -= decompressed_size;
  return std::make_optional(std::move(record));
}

absl::Status RecordReader::CheckSize(uint64_t size, const CompressedRecord& record) const {
  const uint64_t remaining = file_size_ - position_;
  if (size <= remaining) return absl::OkStatus();
  return absl::DataLossError(absl::StrCat(path_, ": ", record.Name(), ": needs ", size,
                                          " more bytes, but only ", remaining,
                                          " are left; the file is truncated or damaged"));
}

absl::Status RecordReader::ReadBytes(size_t size, char* bytes) {
  if (!stream_.read(bytes, static_cast<std::streamsize>(size))) {
    return absl::UnavailableError(absl::StrCat(path_, ": cannot read ", size, " bytes at byte ",
                                               position_, ": ", std::strerror(errno)));
  }
  position_ += size;
  return absl::OkStatus();
}

}  // namespace cartographer::io
