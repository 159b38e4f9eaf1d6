// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RECORD_FORMAT_H_
#define CARTOGRAPHER_IO_RECORD_FORMAT_H_

#include <cstddef>
#include <cstdint>

namespace cartographer::io {

// A pbstream file: kMagic, then records, nothing after the last. A record is the size of its gzip
// member in kSizeBytes bytes, then that member, which holds one serialized message. All integers
// are little endian.
inline constexpr uint64_t kMagic = 0x7b1d1f7b5bf501db;
inline constexpr size_t kSizeBytes = 8;

// A message's largest size: protobuf's traditional limit, which other readers may still have.
inline constexpr size_t kMaxMessageSize = size_t{64} << 20;

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RECORD_FORMAT_H_
