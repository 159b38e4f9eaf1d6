// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SEMANTIC_KITTI_LAYOUT_H_
#define SEMANTIC_KISS_DATASET_SEMANTIC_KITTI_LAYOUT_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "semantic_kiss/dataset/proto/dataset_options.pb.h"

namespace semantic_kiss::dataset {

// Which sequence is read, and with which labels.
struct SemanticKittiLocation {
  // The directory that holds sequences/.
  std::string directory;
  // Name of the sequence, for example "00".
  std::string sequence;
  // Where the labels are. A relative name is a directory of the sequence ("predictions":
  // sequences/NN/predictions). An absolute path is the directory itself, or one laid out like
  // results of the SemanticKITTI benchmark, with sequences/NN/predictions in it. Empty: "labels",
  // if there is such a directory. kNoLabels: the scans are read without labels.
  std::string labels_dir;
  // Another file of true poses than those that the data set has; empty: the data set's.
  std::string ground_truth_file = {};
};
inline constexpr char kNoLabels[] = "none";

// The files of a sequence that were found; an empty path stands for what the sequence lacks.
struct SemanticKittiLayout {
  std::string velodyne_dir;
  std::string labels_dir;
  std::string confidences_dir;
  std::string moving_masks_dir;
  std::string point_times_dir;
  std::string times_file;
  std::string calib_file;
  std::string poses_file;
  // What was chosen or is missing, as ScanSource::notes() wants it.
  std::vector<std::string> notes;
};

// Looks where everything is. Fails if the scans' directory is missing, or anything that `location`
// or `options` asks for by name; the error says what was looked for and what there is.
absl::StatusOr<SemanticKittiLayout> FindSemanticKittiFiles(const SemanticKittiLocation& location,
                                                           const proto::DatasetOptions& options);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SEMANTIC_KITTI_LAYOUT_H_
