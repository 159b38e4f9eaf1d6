// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_FILE_BUFFER_H_
#define SEMANTIC_KISS_DATASET_FILE_BUFFER_H_

#include <cstddef>
#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/strings/string_view.h"

namespace semantic_kiss::dataset {

// The content of one file after another, in memory that only ever grows: reading the thousands of
// scans of a drive then costs neither allocations nor page faults.
class FileBuffer {
 public:
  // Files beyond this size are refused: no scan is that large, and a wrong path should not exhaust
  // the memory.
  static constexpr size_t kMaxBytes = size_t{1} << 30;

  // Replaces the content. Errors name the file; a missing one is NotFound. The content is
  // unspecified after an error.
  absl::Status Read(const std::string& path);

  size_t size() const { return size_; }
  absl::string_view text() const { return absl::string_view(bytes_.get(), size_); }

  // The content as little-endian values of type T; a remainder is left out of count().
  template <typename T>
  const T* As() const {
    return reinterpret_cast<const T*>(bytes_.get());
  }
  template <typename T>
  size_t Count() const {
    return size_ / sizeof(T);
  }

 private:
  absl::Status ReadDescriptor(int descriptor, const std::string& path);

  std::unique_ptr<char[]> bytes_;  // aligned for every scalar type, as operator new gives it
  size_t capacity_ = 0;
  size_t size_ = 0;
};

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_FILE_BUFFER_H_
