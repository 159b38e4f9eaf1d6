// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/class_subsampling.h"

#include <array>

#include "glog/logging.h"
#include "semantic_kiss/odometry/voxel_subsampling.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::kMaxLabels;
using cartographer::sensor::Label;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelMask;

// The cloud cut up by group, what is in none of them last; points keep their order.
std::vector<LabeledPointCloud> Split(const LabeledPointCloud& cloud,
                                     const std::vector<LabelMask>& groups) {
  std::array<size_t, kMaxLabels> group_of_label;
  for (size_t i = 0; i < kMaxLabels; ++i) {
    size_t group = 0;
    while (group < groups.size() && !groups[group].Contains(Label{static_cast<uint8_t>(i)})) {
      ++group;
    }
    group_of_label[i] = group;
  }
  std::vector<LabeledPointCloud> parts(groups.size() + 1);
  for (size_t i = 0; i < cloud.size(); ++i) {
    parts[group_of_label[cartographer::sensor::Index(cloud.labels[i])]].Append(cloud, i);
  }
  return parts;
}

}  // namespace

LabeledPointCloud SubsampleByClass(const LabeledPointCloud& cloud,
                                   const proto::SubsamplingOptions& options,
                                   const std::vector<LabelMask>& groups,
                                   const LabelMask& critical) {
  CHECK_EQ(groups.size(), static_cast<size_t>(options.class_voxels_size()));
  if (groups.empty()) return Subsample(cloud, options, critical);
  LabeledPointCloud result;
  const std::vector<LabeledPointCloud> parts = Split(cloud, groups);
  for (size_t group = 0; group < parts.size(); ++group) {
    proto::SubsamplingOptions part_options = options;
    if (group < groups.size()) {
      part_options.set_voxel_size_m(options.class_voxels(static_cast<int>(group)).voxel_size_m());
    }
    const LabeledPointCloud part = Subsample(parts[group], part_options, critical);
    for (size_t i = 0; i < part.size(); ++i) result.Append(part, i);
  }
  return result;
}

}  // namespace semantic_kiss::odometry
