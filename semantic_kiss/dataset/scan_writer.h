// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SCAN_WRITER_H_
#define SEMANTIC_KISS_DATASET_SCAN_WRITER_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "cartographer/common/time.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"

namespace semantic_kiss::dataset {

// The files of one scan in SemanticKITTI's layout, N points each.
struct ScanFiles {
  std::vector<std::array<float, 4>> points;          // x, y, z [m], remission in [0, 1]
  std::optional<std::vector<uint32_t>> label_words;  // instance << 16 | class id
  std::optional<std::vector<float>> certainties;     // in [0, 1]
  std::optional<std::vector<float>> times_s;         // relative to the scan's time
};

// What files can carry of a cloud: labels (and certainties) only if the set has any.
ScanFiles FilesOf(const cartographer::sensor::LabeledPointCloud& cloud,
                  const cartographer::sensor::LabelSet& labels);

// The file with the points of a scan, sequences/NN/velodyne/NNNNNN.bin. It is written last: where
// it stands the scan is complete.
std::string PointFileOf(const std::string& sequence_directory, int scan);

// Writes a scan into DIR/sequences/NN, whose folders are made as needed. Every file appears whole
// or not at all.
absl::Status WriteScanFiles(const std::string& sequence_directory, int scan,
                            const ScanFiles& files);

// times.txt: the seconds of each scan, one a line.
absl::Status WriteScanTimes(const std::string& sequence_directory,
                            const std::vector<cartographer::common::Time>& times);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SCAN_WRITER_H_
