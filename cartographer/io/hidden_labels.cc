// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/hidden_labels.h"

#include <string>

#include "cartographer/common/status.h"

namespace cartographer::io {
namespace {

using sensor::Label;
using sensor::LabelMask;

absl::StatusOr<LabelMask> Named(const google::protobuf::RepeatedPtrField<std::string>& names,
                                const char* option, const sensor::LabelSet& labels) {
  absl::StatusOr<LabelMask> mask = labels.FromNames(names);
  if (!mask.ok()) return common::AddContext(mask.status(), option);
  return mask;
}

// `is_shown` decides about the labels that are not in `hide`, given whether they are in `show`.
template <typename IsShown>
absl::StatusOr<LabelMask> Hidden(const proto::RenderOptions& options,
                                 const sensor::LabelSet& labels, const IsShown& is_shown) {
  ASSIGN_OR_RETURN(LabelMask hidden, Named(options.hide(), "hide", labels));
  ASSIGN_OR_RETURN(const LabelMask shown, Named(options.show(), "show", labels));
  for (size_t i = 0; i < labels.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (!is_shown(label, shown.Contains(label))) hidden.Insert(label);
  }
  return hidden;
}

}  // namespace

absl::StatusOr<LabelMask> HiddenLabels(const proto::RenderOptions& options,
                                       const sensor::LabelSet& labels) {
  return Hidden(options, labels,
                [&](Label, bool named) { return named || options.show().empty(); });
}

absl::StatusOr<LabelMask> LabelsHiddenFromOccupancy(const proto::RenderOptions& options,
                                                    const sensor::LabelSet& labels) {
  return Hidden(options, labels, [&](Label label, bool named) {
    if (named || labels.HasRole(label, sensor::LabelRole::kGround)) return true;
    return options.show().empty() && !labels.HasRole(label, sensor::LabelRole::kMoving);
  });
}

}  // namespace cartographer::io
