// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_STATUS_H_
#define CARTOGRAPHER_COMMON_STATUS_H_

#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

// Returns from the calling function if `expression`, an absl::Status, is not OK.
#define RETURN_IF_ERROR(expression)                  \
  do {                                               \
    absl::Status status_of_line = (expression);      \
    if (!status_of_line.ok()) return status_of_line; \
  } while (false)

// Evaluates `expression`, an absl::StatusOr<T>; assigns its value to `target`
// (which may be a declaration) or returns its status from the calling function.
#define ASSIGN_OR_RETURN(target, expression) \
  ASSIGN_OR_RETURN_NAMED_(STATUS_CONCAT_(status_or_of_line_, __LINE__), target, expression)

#define ASSIGN_OR_RETURN_NAMED_(status_or, target, expression) \
  auto status_or = (expression);                               \
  if (!status_or.ok()) return std::move(status_or).status();   \
  target = *std::move(status_or)
#define STATUS_CONCAT_(a, b) STATUS_CONCAT_INNER_(a, b)
#define STATUS_CONCAT_INNER_(a, b) a##b

namespace cartographer::common {

// Prefixes the message of a failed status with where it happened, for example a file's name:
// "scans/000001.bin: size is 17 bytes, ...". An OK status is returned as it is.
absl::Status AddContext(const absl::Status& status, absl::string_view context);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_STATUS_H_
