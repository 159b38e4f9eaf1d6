// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/label_choice.h"

#include "cartographer/common/status.h"
#include "cartographer/sensor/label_set_check.h"

namespace cartographer::map {
namespace {

using Words = google::protobuf::RepeatedPtrField<std::string>;

absl::Status AddNamed(const Words& names, const sensor::LabelSet& labels, sensor::LabelMask* mask) {
  for (const std::string& name : names) {
    ASSIGN_OR_RETURN(const sensor::Label label, labels.FromName(name));
    mask->Insert(label);
  }
  return absl::OkStatus();
}

absl::Status AddWithRoles(const Words& words, const sensor::LabelSet& labels,
                          sensor::LabelMask* mask) {
  for (const std::string& word : words) {
    ASSIGN_OR_RETURN(const sensor::LabelRole role, sensor::RoleFromWord(word));
    for (size_t i = 0; i < labels.size(); ++i) {
      const sensor::Label label{static_cast<uint8_t>(i)};
      if (labels.HasRole(label, role)) mask->Insert(label);
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<sensor::LabelMask> LabelsToRemove(const proto::FilterOptions& options,
                                                 const sensor::LabelSet& labels) {
  const bool removes = !options.remove().empty() || !options.remove_roles().empty();
  const bool keeps = !options.keep().empty() || !options.keep_roles().empty();
  if (removes && keeps) {
    return absl::InvalidArgumentError(
        "keep: there is something to remove as well; give one of "
        "the two, for all that is not kept is removed");
  }
  using common::AddContext;
  sensor::LabelMask named;
  RETURN_IF_ERROR(AddContext(AddNamed(options.remove(), labels, &named), "remove"));
  RETURN_IF_ERROR(AddContext(AddWithRoles(options.remove_roles(), labels, &named), "remove_role"));
  RETURN_IF_ERROR(AddContext(AddNamed(options.keep(), labels, &named), "keep"));
  RETURN_IF_ERROR(AddContext(AddWithRoles(options.keep_roles(), labels, &named), "keep_role"));
  if (!keeps) return named;
  sensor::LabelMask others;
  for (size_t i = 0; i < labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    if (!named.Contains(label)) others.Insert(label);
  }
  return others;
}

}  // namespace cartographer::map
