// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SEQUENCE_DIRECTORY_H_
#define SEMANTIC_KISS_DATASET_SEQUENCE_DIRECTORY_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace semantic_kiss::dataset {

// Where a sequence is written, ROOT/sequences/NN. Its name must be that of one folder, so that
// nothing is written elsewhere: InvalidArgument for "", ".", ".." and names with a slash.
absl::StatusOr<std::string> SequenceDirectory(const std::string& root, const std::string& sequence);

// Makes a directory and its parents where they are missing; PermissionDenied with the reason.
absl::Status MakeDirectory(const std::string& path);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SEQUENCE_DIRECTORY_H_
