// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_LABEL_FILE_H_
#define SEMANTIC_KISS_DATASET_LABEL_FILE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/dataset/file_buffer.h"
#include "semantic_kiss/dataset/scan_source.h"

namespace semantic_kiss::dataset {

// A label file holds a uint32 for each point of its scan: the class's id in the low 16 bits (an
// instance number in the others is ignored).
//
// Reads the file at `path`, by way of `buffer`, into `labels`, which has `num_points` entries
// afterwards. Ids that `set` does not list become kUnlabeled and are counted in `unknown_ids`.
// Fails if the file does not hold `num_points` values; the error names the file and both counts.
struct LabelFile {
  const std::string& path;
  size_t num_points;
};
absl::Status ReadLabels(const LabelFile& file, const cartographer::sensor::LabelSet& set,
                        FileBuffer* buffer, std::vector<cartographer::sensor::Label>* labels,
                        UnknownLabelIds* unknown_ids);

// What becomes of a label where a moving-object mask says that the point moves. In label sets the
// class "moving-NAME" is the moving variant of NAME if it has the role `moving`.
//   - A class with a moving variant becomes it.
//   - A moving class stays.
//   - An unlabeled point, or a movable class without a variant of its own (a parked bicycle),
//     becomes the set's first moving class: all that counts is that it moves.
//   - Anything else (road, building) stays: masks bleed over the borders of objects, and what
//     cannot move does not.
class MovingVariants {
 public:
  // Fails if the set has no class with the role `moving`.
  static absl::StatusOr<MovingVariants> Create(const cartographer::sensor::LabelSet& set);

  cartographer::sensor::Label Of(cartographer::sensor::Label label) const {
    return variants_[cartographer::sensor::Index(label)];
  }

  // Applies the mask in the file at `path`: a uint32 for each point, of which the low 16 bits are
  // 0 (unknown), 9 (static) or 251 (moving). Fails on other values (then it is no mask) and on a
  // count other than labels->size().
  absl::Status ApplyMask(const std::string& path, FileBuffer* buffer,
                         std::vector<cartographer::sensor::Label>* labels) const;

 private:
  std::array<cartographer::sensor::Label, cartographer::sensor::kMaxLabels> variants_{};
};

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_LABEL_FILE_H_
