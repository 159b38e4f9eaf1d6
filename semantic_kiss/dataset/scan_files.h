// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SCAN_FILES_H_
#define SEMANTIC_KISS_DATASET_SCAN_FILES_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace semantic_kiss::dataset {

// A scan's files are called by its number: velodyne/000012.bin, labels/000012.label and so on.
struct ScanFile {
  int number = 0;
  std::string stem;  // the number as the file's name has it, for example "000012"
};

// A stretch of a sequence, by the numbers of its scans.
struct ScanRange {
  std::optional<int> first;  // nullopt: the lowest number that there is
  std::optional<int> count;  // nullopt: to the end; may be more than there are
};

// Lists the scans NUMBER.bin (a number is digits only; other files are ignored) of `directory`
// within `range`, in ascending order. Fails if there is none, if two files have the same number or
// if a number between the first and the last is missing.
absl::StatusOr<std::vector<ScanFile>> ListScanFiles(const std::string& directory,
                                                    const ScanRange& range);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SCAN_FILES_H_
