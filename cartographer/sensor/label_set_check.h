// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SENSOR_LABEL_SET_CHECK_H_
#define CARTOGRAPHER_SENSOR_LABEL_SET_CHECK_H_

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/proto/label_set.pb.h"

namespace cartographer::sensor {

// The word for a role in label sets and flags: "moving", "movable", "critical", "ground",
// "unlabeled".
absl::string_view RoleWord(LabelRole role);

// The reverse; InvalidArgument tells the nearest word.
absl::StatusOr<LabelRole> RoleFromWord(absl::string_view word);

// Whether LabelSet::Create() can make a set of the declaration; the rules stand there. Maps carry
// declarations too, so that ranges and words are checked here as well as by the options loader.
absl::Status CheckLabelSet(const proto::LabelSet& declaration);

}  // namespace cartographer::sensor

#endif  // CARTOGRAPHER_SENSOR_LABEL_SET_CHECK_H_
