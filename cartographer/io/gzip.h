// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_GZIP_H_
#define CARTOGRAPHER_IO_GZIP_H_

#include <cstddef>
#include <string>

#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"

namespace cartographer::io {

// One gzip member. The bytes depend on `data` alone: no time, name or system stands in the header.
std::string GzipCompress(absl::string_view data);

// The content of `member`, which must be exactly one gzip member. What a member says about its own
// size is not trusted: memory grows with what really comes out, and more than `max_size` bytes are
// refused before any is produced. kDataLoss if it is damaged.
absl::StatusOr<std::string> GzipDecompress(absl::string_view member, size_t max_size);

// The size of the content as the member's trailer has it, true only in intact members; 0 if
// `member` is too short to have one.
size_t GzipClaimedSize(absl::string_view member);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_GZIP_H_
