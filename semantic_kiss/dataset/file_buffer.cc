// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/file_buffer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "absl/strings/str_cat.h"

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the files are read without byte swaps");

namespace semantic_kiss::dataset {
namespace {

absl::Status SystemError(const std::string& path, int error) {
  return absl::ErrnoToStatus(error, absl::StrCat(path, ": cannot be read"));
}

}  // namespace

absl::Status FileBuffer::Read(const std::string& path) {
  const int descriptor =
      open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // no waiting at pipes
  if (descriptor < 0) return SystemError(path, errno);
  const absl::Status status = ReadDescriptor(descriptor, path);
  close(descriptor);
  return status;
}

absl::Status FileBuffer::ReadDescriptor(int descriptor, const std::string& path) {
  struct stat info;
  if (fstat(descriptor, &info) != 0) return SystemError(path, errno);
  if (!S_ISREG(info.st_mode)) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": is not a regular file"));
  }
  const size_t size = static_cast<size_t>(info.st_size);
  if (size > kMaxBytes) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": has ", size, " bytes; at most ",
                                                   kMaxBytes, " are read, is it the right file?"));
  }
  if (size > capacity_) {
    const size_t capacity = size + size / 8;  // scans vary: few of them are the largest so far
    bytes_.reset(new char[capacity]);
    capacity_ = capacity;  // not before: if there is no memory the old bytes stay
  }
  size_ = 0;
  while (size_ < size) {
    const ssize_t count = read(descriptor, bytes_.get() + size_, size - size_);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return SystemError(path, errno);
    if (count == 0) {
      return absl::DataLossError(absl::StrCat(path, ": ended after ", size_, " of ", size,
                                              " bytes; is it still being written?"));
    }
    size_ += static_cast<size_t>(count);
  }
  return absl::OkStatus();
}

}  // namespace semantic_kiss::dataset
