// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/certainty_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::sensor::Index;
using cartographer::sensor::Label;
using cartographer::sensor::LabelRole;
using cartographer::sensor::LabelSet;

// Rows come from networks that may have computed, or stored, them in half precision.
constexpr float kRowSumTolerance = 0.01f;

// False for NaN too.
bool IsProbability(float value) { return value >= 0.f && value <= 1.f; }

absl::Status NotAProbability(const std::string& path, absl::string_view where, float value) {
  return absl::InvalidArgumentError(
      absl::StrCat(path, ": certainty of ", where, " is ", value,
                   ", which is not in [0, 1]; probabilities are needed, not logits or per cent"));
}

size_t FirstNonProbability(const float* values, size_t count) {
  return std::find_if_not(values, values + count, IsProbability) - values;
}

}  // namespace

CertaintyReader::CertaintyReader(const LabelSet& set, const std::vector<uint16_t>& column_ids)
    : num_columns_(column_ids.size()), columns_of_label_(set.size()) {
  for (size_t column = 0; column < column_ids.size() && columns_status_.ok(); ++column) {
    const std::optional<Label> label = set.FromFileId(column_ids[column]);
    if (label.has_value()) {
      columns_of_label_[Index(*label)].push_back(static_cast<int>(column));
      continue;
    }
    columns_status_ = absl::InvalidArgumentError(
        absl::StrCat("column ", column, " stands for the id ", column_ids[column],
                     ", which label set \"", set.name(),
                     "\" does not list; let dataset.confidence_columns name the ids of the "
                     "file's columns"));
  }
  for (size_t i = 0; i < set.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    default_of_label_.push_back(set.DefaultCertainty(label));
    absl::string_view name = set.Name(label);
    if (!columns_of_label_[i].empty() || !set.HasRole(label, LabelRole::kMoving) ||
        !absl::ConsumePrefix(&name, "moving-")) {
      continue;
    }
    const absl::StatusOr<Label> namesake = set.FromName(name);
    if (namesake.ok()) columns_of_label_[i] = columns_of_label_[Index(*namesake)];
  }
}

void CertaintyReader::FillDefaults(const std::vector<Label>& labels,
                                   std::vector<float>* certainties) const {
  certainties->resize(labels.size());
  for (size_t i = 0; i < labels.size(); ++i) {
    (*certainties)[i] = default_of_label_[Index(labels[i])];
  }
}

absl::Status CertaintyReader::Read(const std::string& path, const std::vector<Label>& labels,
                                   FileBuffer* buffer, std::vector<float>* certainties) const {
  RETURN_IF_ERROR(buffer->Read(path));
  certainties->resize(labels.size());
  const size_t bytes_per_column = labels.size() * sizeof(float);
  if (buffer->size() == bytes_per_column) return TakeColumn(path, *buffer, certainties);
  if (num_columns_ > 0 && buffer->size() == bytes_per_column * num_columns_) {
    RETURN_IF_ERROR(cartographer::common::AddContext(columns_status_, path));
    return TakeLabels(path, *buffer, labels, certainties);
  }
  return absl::InvalidArgumentError(absl::StrCat(
      path, ": size is ", buffer->size(), " bytes; for a scan of ", labels.size(), " points it is ",
      bytes_per_column, " (a certainty a point) or ", bytes_per_column * num_columns_,
      " (probabilities of ", num_columns_, " classes a point; option confidence_columns)"));
}

absl::Status CertaintyReader::TakeColumn(const std::string& path, const FileBuffer& buffer,
                                         std::vector<float>* certainties) const {
  const float* const values = buffer.As<float>();
  bool all_valid = true;
  for (size_t i = 0; i < certainties->size(); ++i) {
    (*certainties)[i] = values[i];
    all_valid &= IsProbability(values[i]);
  }
  if (all_valid) return absl::OkStatus();
  const size_t point = FirstNonProbability(values, certainties->size());
  return NotAProbability(path, absl::StrCat("point ", point), values[point]);
}

absl::Status CertaintyReader::TakeLabels(const std::string& path, const FileBuffer& buffer,
                                         const std::vector<Label>& labels,
                                         std::vector<float>* certainties) const {
  for (size_t i = 0; i < labels.size(); ++i) {
    const float* const row = buffer.As<float>() + i * num_columns_;
    bool all_valid = true;
    float sum = 0.f;
    for (size_t column = 0; column < num_columns_; ++column) {
      sum += row[column];
      all_valid &= IsProbability(row[column]);
    }
    if (!all_valid) {
      const size_t column = FirstNonProbability(row, num_columns_);
      return NotAProbability(path, absl::StrCat("point ", i, ", column ", column), row[column]);
    }
    if (std::abs(sum - 1.f) > kRowSumTolerance) {
      return absl::InvalidArgumentError(absl::StrCat(path, ": probabilities of point ", i,
                                                     " sum to ", sum,
                                                     ", not to 1; are they softmax values?"));
    }
    const std::vector<int>& columns = columns_of_label_[Index(labels[i])];
    float certainty = columns.empty() ? default_of_label_[Index(labels[i])] : 0.f;
    for (const int column : columns) certainty += row[column];
    (*certainties)[i] = std::min(certainty, 1.f);
  }
  return absl::OkStatus();
}

}  // namespace semantic_kiss::dataset
