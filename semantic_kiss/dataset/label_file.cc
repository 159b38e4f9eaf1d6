// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/label_file.h"

#include <optional>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using cartographer::sensor::LabelRole;
using cartographer::sensor::LabelSet;

constexpr uint16_t kMaskUnknown = 0;
constexpr uint16_t kMaskStatic = 9;
constexpr uint16_t kMaskMoving = 251;

// Loads `path` and checks that it holds one uint32 for each of `num_points` points.
absl::Status ReadValues(const std::string& path, size_t num_points, absl::string_view what,
                        FileBuffer* buffer) {
  RETURN_IF_ERROR(buffer->Read(path));
  if (buffer->size() == num_points * sizeof(uint32_t)) return absl::OkStatus();
  if (buffer->size() % sizeof(uint32_t) != 0) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": size is ", buffer->size(),
                                                   " bytes, not a multiple of 4; ", what,
                                                   " are one uint32 a point"));
  }
  return absl::InvalidArgumentError(absl::StrCat(path, ": has ", buffer->Count<uint32_t>(), " ",
                                                 what, " for a scan of ", num_points,
                                                 " points; do both belong to the same sequence?"));
}

Label FirstWithRole(const LabelSet& set, LabelRole role) {
  for (size_t i = 0; i < set.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (set.HasRole(label, role)) return label;
  }
  return kUnlabeled;
}

}  // namespace

absl::Status ReadLabels(const LabelFile& file, const LabelSet& set, FileBuffer* buffer,
                        std::vector<Label>* labels, UnknownLabelIds* unknown_ids) {
  RETURN_IF_ERROR(ReadValues(file.path, file.num_points, "labels", buffer));
  labels->resize(file.num_points);
  const uint32_t* const values = buffer->As<uint32_t>();
  for (size_t i = 0; i < file.num_points; ++i) {
    const uint16_t id = static_cast<uint16_t>(values[i]);
    const std::optional<Label> label = set.FromFileId(id);
    (*labels)[i] = label.value_or(kUnlabeled);
    if (!label.has_value()) ++(*unknown_ids)[id];
  }
  return absl::OkStatus();
}

absl::StatusOr<MovingVariants> MovingVariants::Create(const LabelSet& set) {
  const Label some_moving = FirstWithRole(set, LabelRole::kMoving);
  if (some_moving == kUnlabeled) {
    return absl::InvalidArgumentError(
        absl::StrCat("label set \"", set.name(),
                     "\": no class has the role \"moving\", which moving-object masks need"));
  }
  MovingVariants result;
  for (size_t i = 0; i < set.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    const absl::StatusOr<Label> variant = set.FromName(absl::StrCat("moving-", set.Name(label)));
    if (variant.ok() && set.HasRole(*variant, LabelRole::kMoving)) {
      result.variants_[i] = *variant;
    } else if (!set.HasRole(label, LabelRole::kMoving) &&
               (label == kUnlabeled || set.HasRole(label, LabelRole::kMovable))) {
      result.variants_[i] = some_moving;
    } else {
      result.variants_[i] = label;
    }
  }
  return result;
}

absl::Status MovingVariants::ApplyMask(const std::string& path, FileBuffer* buffer,
                                       std::vector<Label>* labels) const {
  RETURN_IF_ERROR(ReadValues(path, labels->size(), "mask values", buffer));
  const uint32_t* const values = buffer->As<uint32_t>();
  for (size_t i = 0; i < labels->size(); ++i) {
    const uint16_t value = static_cast<uint16_t>(values[i]);
    if (value == kMaskMoving) {
      (*labels)[i] = Of((*labels)[i]);
    } else if (value != kMaskStatic && value != kMaskUnknown) {
      return absl::InvalidArgumentError(
          absl::StrCat(path, ": point ", i, " has the value ", value,
                       "; a moving-object mask holds 9 (static), 251 (moving) or 0 (unknown)"));
    }
  }
  return absl::OkStatus();
}

}  // namespace semantic_kiss::dataset
