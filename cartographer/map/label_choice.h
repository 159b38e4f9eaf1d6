// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_LABEL_CHOICE_H_
#define CARTOGRAPHER_MAP_LABEL_CHOICE_H_

#include "absl/status/statusor.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::map {

// The labels that the options remove: those named by `remove` and `remove_roles`, or all but those
// named by `keep` and `keep_roles`; none if nothing is named. Errors begin with the option: an
// unknown name or role, `keep` beside `remove`.
absl::StatusOr<sensor::LabelMask> LabelsToRemove(const proto::FilterOptions& options,
                                                 const sensor::LabelSet& labels);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_LABEL_CHOICE_H_
