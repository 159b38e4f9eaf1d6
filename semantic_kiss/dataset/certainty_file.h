// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_CERTAINTY_FILE_H_
#define SEMANTIC_KISS_DATASET_CERTAINTY_FILE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/dataset/file_buffer.h"

namespace semantic_kiss::dataset {

// Reads how certain the labels of a scan are. For N points a file holds float32 values, either
//   N      the certainty of each point's label, in [0, 1], or
//   N x C  a row for each point: the probabilities of C classes, each in [0, 1], their sum 1
//          within 0.01.
// The size of the file tells which. Of a row, the point's certainty is the sum of the columns whose
// classes carry the point's label (one column, or several where the label set merges classes). A
// moving class without a column of its own takes that of its static namesake ("moving-car": car),
// since that is how the usual class list folds them. Labels that still have no column get their
// class's default.
class CertaintyReader {
 public:
  // Knows no label.
  CertaintyReader() = default;

  // `column_ids` are the file ids of the C columns, in order. If `set` does not list one of them,
  // files with rows are refused, which matters only where there are some.
  CertaintyReader(const cartographer::sensor::LabelSet& set,
                  const std::vector<uint16_t>& column_ids);

  // The certainty of each label where no file gives one.
  void FillDefaults(const std::vector<cartographer::sensor::Label>& labels,
                    std::vector<float>* certainties) const;

  // Reads the file at `path`, by way of `buffer`. Errors name the file and, for a value, its point,
  // column and the value.
  absl::Status Read(const std::string& path, const std::vector<cartographer::sensor::Label>& labels,
                    FileBuffer* buffer, std::vector<float>* certainties) const;

 private:
  absl::Status TakeColumn(const std::string& path, const FileBuffer& buffer,
                          std::vector<float>* certainties) const;
  absl::Status TakeLabels(const std::string& path, const FileBuffer& buffer,
                          const std::vector<cartographer::sensor::Label>& labels,
                          std::vector<float>* certainties) const;

  size_t num_columns_ = 0;
  absl::Status columns_status_;
  // By label: the columns that count for it; none: the default is taken.
  std::vector<std::vector<int>> columns_of_label_;
  std::vector<float> default_of_label_;
};

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_CERTAINTY_FILE_H_
