// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SEMANTIC_KITTI_SOURCE_H_
#define SEMANTIC_KISS_DATASET_SEMANTIC_KITTI_SOURCE_H_

#include <memory>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/dataset/proto/dataset_options.pb.h"
#include "semantic_kiss/dataset/scan_files.h"
#include "semantic_kiss/dataset/scan_source.h"
#include "semantic_kiss/dataset/semantic_kitti_layout.h"

namespace semantic_kiss::dataset {

// Opens a sequence in SemanticKITTI's format; docs/file_formats.md describes its files.
//
// Scans go by the numbers of their files, and line N (counted from 0) of times.txt and of the poses
// belongs to scan N; these files may have more lines than there are scans, not fewer.
// `LabeledScan::index` is the number. With Tr in calib.txt the poses are the camera's and
// ground_truth() is Tr^-1 * pose * Tr, else they are the lidar's own.
//
// Everything but the scans themselves is read here, so most mistakes show at once. Errors name file
// and position, say what is wrong and what is expected.
absl::StatusOr<std::unique_ptr<ScanSource>> OpenSemanticKitti(
    const SemanticKittiLocation& location, const ScanRange& range,
    const proto::DatasetOptions& options, const cartographer::sensor::LabelSet& labels);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SEMANTIC_KITTI_SOURCE_H_
