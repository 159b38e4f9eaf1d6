// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_FILE_HASH_H_
#define SEMANTIC_KISS_CLI_FILE_HASH_H_

#include <string>

#include "absl/status/statusor.h"

namespace semantic_kiss::cli {

// The SHA-256 of a file's bytes in hexadecimal digits, as sha256sum prints it. Errors name the
// file.
absl::StatusOr<std::string> Sha256OfFile(const std::string& path);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_FILE_HASH_H_
