// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_HIDDEN_LABELS_H_
#define CARTOGRAPHER_IO_HIDDEN_LABELS_H_

#include "absl/status/statusor.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::io {

// The labels that are left out: those in `hide`, and those that are not in `show` unless that is
// empty. Errors begin with the option that names an unknown label.
absl::StatusOr<sensor::LabelMask> HiddenLabels(const proto::RenderOptions& options,
                                               const sensor::LabelSet& labels);

// The same for occupancy grids: the ground is there unless it is in `hide`, moving labels are not
// unless they are in `show`.
absl::StatusOr<sensor::LabelMask> LabelsHiddenFromOccupancy(const proto::RenderOptions& options,
                                                            const sensor::LabelSet& labels);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_HIDDEN_LABELS_H_
