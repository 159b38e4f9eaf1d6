// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/closure_target.h"

namespace cartographer::pose_graph {
namespace {

registration::LabeledVoxelMap Join(const std::vector<ClosureTarget::Part>& parts,
                                   const sensor::LabelSet& labels,
                                   const proto::VerificationOptions& options) {
  registration::LabeledVoxelMap joined(options.target(),
                                       labels.WithRole(sensor::LabelRole::kCritical));
  for (const ClosureTarget::Part& part : parts) joined.Insert(*part.cloud, part.target_from_cloud);
  return joined;
}

GroundHeights GroundOf(const std::vector<ClosureTarget::Part>& parts,
                       const sensor::LabelMask& ground_labels, double cell_m) {
  GroundHeights ground(cell_m);
  for (const ClosureTarget::Part& part : parts) {
    ground.Add(*part.cloud, part.target_from_cloud, ground_labels);
  }
  return ground;
}

}  // namespace

ClosureTarget::ClosureTarget(const std::vector<Part>& parts, const sensor::LabelSet& labels,
                             const proto::VerificationOptions& options)
    : ground_labels_(labels.WithRole(sensor::LabelRole::kGround)),
      points_(Join(parts, labels, options)),
      ground_(GroundOf(parts, ground_labels_, options.ground().cell_m())),
      surfaces_(points_.ToPointCloud(), options.target().voxel_size_m(),
                options.information().point_sigma_m()) {
  for (const Part& part : parts) {
    for (const Eigen::Vector3f& position : part.cloud->positions) {
      box_.extend(part.target_from_cloud * position.cast<double>());
    }
  }
}

}  // namespace cartographer::pose_graph
