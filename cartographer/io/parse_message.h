// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_PARSE_MESSAGE_H_
#define CARTOGRAPHER_IO_PARSE_MESSAGE_H_

#include <string>

#include "absl/status/status.h"
#include "google/protobuf/message.h"

namespace cartographer::io {

// Parses a serialized message that is not trusted. A few bytes can stand for an empty message that
// takes far more memory, so a crafted file of kilobytes could fill the machine: `bytes` are
// refused (kDataLoss) before any memory is taken if the objects that they stand for would need
// over 8 times their size plus 1 MiB.
absl::Status ParseMessage(const std::string& bytes, google::protobuf::Message* message);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_PARSE_MESSAGE_H_
