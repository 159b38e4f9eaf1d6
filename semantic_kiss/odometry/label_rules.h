// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_LABEL_RULES_H_
#define SEMANTIC_KISS_ODOMETRY_LABEL_RULES_H_

#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss::odometry {

// What the options' roles and names of classes mean in a label set.
struct LabelRules {
  // Errors name the option: a class that the set does not have, a class in two groups of
  // `class_voxels`.
  static absl::StatusOr<LabelRules> Create(const proto::OdometryOptions& options,
                                           const cartographer::sensor::LabelSet& labels);

  cartographer::sensor::LabelMask dropped;   // by preprocessing
  cartographer::sensor::LabelMask critical;  // spared by sub-samplings and the local map
  // The groups of `class_voxels` of the two sub-samplings, in their order.
  std::vector<cartographer::sensor::LabelMask> map_classes;
  std::vector<cartographer::sensor::LabelMask> icp_classes;
};

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_LABEL_RULES_H_
