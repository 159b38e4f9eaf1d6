// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_CLASS_SUBSAMPLING_H_
#define SEMANTIC_KISS_ODOMETRY_CLASS_SUBSAMPLING_H_

#include <vector>

#include "cartographer/sensor/labeled_point_cloud.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss::odometry {

// Subsample() (voxel_subsampling.h) for every group of classes on its own: the points of
// `groups[i]` in voxels of `options.class_voxels(i).voxel_size_m`, all others in voxels of
// `options.voxel_size_m`. Results follow one another in the order of the groups, the others last;
// without groups it is Subsample(). Groups must be as many as the options have (CHECKed), and
// disjoint.
//
// Groups do not share voxels even where their sizes are equal, so that a building never hides a
// car. Source: SAGE-ICP, adaptive voxel sizes by class.
cartographer::sensor::LabeledPointCloud SubsampleByClass(
    const cartographer::sensor::LabeledPointCloud& cloud, const proto::SubsamplingOptions& options,
    const std::vector<cartographer::sensor::LabelMask>& groups,
    const cartographer::sensor::LabelMask& critical);

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_CLASS_SUBSAMPLING_H_
