// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/label_rules.h"

#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::common::AddContext;
using cartographer::sensor::LabelMask;
using cartographer::sensor::LabelRole;
using cartographer::sensor::LabelSet;
using Names = google::protobuf::RepeatedPtrField<std::string>;

absl::StatusOr<LabelMask> Named(const Names& names, const LabelSet& labels, const char* option) {
  absl::StatusOr<LabelMask> mask = labels.FromNames(names);
  if (!mask.ok()) return AddContext(mask.status(), option);
  return mask;
}

absl::StatusOr<std::vector<LabelMask>> Groups(const proto::SubsamplingOptions& options,
                                              const LabelSet& labels, const char* option) {
  std::vector<LabelMask> groups;
  LabelMask taken;
  for (const proto::ClassVoxels& classes : options.class_voxels()) {
    ASSIGN_OR_RETURN(const LabelMask group, Named(classes.labels(), labels, option));
    for (const std::string& name : classes.labels()) {
      if (!taken.Contains(*labels.FromName(name))) continue;
      return absl::InvalidArgumentError(
          absl::StrCat(option, ": class \"", name, "\" is in another group already"));
    }
    taken.Insert(group);
    groups.push_back(group);
  }
  return groups;
}

}  // namespace

absl::StatusOr<LabelRules> LabelRules::Create(const proto::OdometryOptions& options,
                                              const LabelSet& labels) {
  LabelRules rules;
  const proto::PreprocessingOptions& preprocessing = options.preprocessing();
  ASSIGN_OR_RETURN(rules.dropped,
                   Named(preprocessing.drop_labels(), labels, "preprocessing.drop_labels"));
  if (preprocessing.drop_moving()) rules.dropped.Insert(labels.WithRole(LabelRole::kMoving));
  ASSIGN_OR_RETURN(rules.critical, Named(options.critical_labels(), labels, "critical_labels"));
  rules.critical.Insert(labels.WithRole(LabelRole::kCritical));
  ASSIGN_OR_RETURN(rules.map_classes,
                   Groups(options.map_subsampling(), labels, "map_subsampling.class_voxels"));
  ASSIGN_OR_RETURN(rules.icp_classes,
                   Groups(options.icp_subsampling(), labels, "icp_subsampling.class_voxels"));
  return rules;
}

}  // namespace semantic_kiss::odometry
