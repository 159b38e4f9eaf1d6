// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_CLOSURE_TARGET_H_
#define CARTOGRAPHER_POSE_GRAPH_CLOSURE_TARGET_H_

#include <Eigen/Geometry>
#include <vector>

#include "cartographer/pose_graph/ground_heights.h"
#include "cartographer/pose_graph/local_surfaces.h"
#include "cartographer/pose_graph/proto/verification_options.pb.h"
#include "cartographer/registration/labeled_voxel_map.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// What a submap, or a few neighbouring ones joined, offers for the verification of closures: points
// to register against, what their shapes tell, the ground. It takes some milliseconds to make, so
// keep it as long as candidates for the submap come. Immutable; may be used by several threads.
class ClosureTarget {
 public:
  struct Part {
    const sensor::LabeledPointCloud* cloud;  // a submap's; not null, not needed after construction
    transform::Rigid3d target_from_cloud;
  };

  // The frame is the caller's choice, but level: usually that of the submap which was matched,
  // whose own cloud is a part at the identity. Earlier parts take precedence where voxels fill up.
  ClosureTarget(const std::vector<Part>& parts, const sensor::LabelSet& labels,
                const proto::VerificationOptions& options);

  const registration::LabeledVoxelMap& points() const { return points_; }
  const LocalSurfaces& surfaces() const { return surfaces_; }
  const GroundHeights& ground() const { return ground_; }
  // The labels that give the height.
  const sensor::LabelMask& ground_labels() const { return ground_labels_; }
  // Of all points; empty (min > max) without any.
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  const sensor::LabelMask ground_labels_;
  registration::LabeledVoxelMap points_;
  GroundHeights ground_;
  LocalSurfaces surfaces_;
  Eigen::AlignedBox3d box_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_CLOSURE_TARGET_H_
