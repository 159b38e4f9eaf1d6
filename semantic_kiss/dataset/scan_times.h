// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SCAN_TIMES_H_
#define SEMANTIC_KISS_DATASET_SCAN_TIMES_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/time.h"

namespace semantic_kiss::dataset {

// Reads times.txt: one number a line, the time of the scan that has the line's number (counted from
// 0) [s, since the Unix epoch or since the start of the drive]. Blank lines may only end the file.
// Times must increase from line to line by the resolution of common::Time, 100 ns, at least.
// Errors name the file and the line, counted from 1; NotFound if there is no such file.
absl::StatusOr<std::vector<cartographer::common::Time>> ReadScanTimes(const std::string& path);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SCAN_TIMES_H_
