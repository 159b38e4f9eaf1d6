// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_VOXEL_SUBSAMPLING_H_
#define SEMANTIC_KISS_ODOMETRY_VOXEL_SUBSAMPLING_H_

#include "cartographer/sensor/labeled_point_cloud.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss::odometry {

// Thins a cloud to a few points per voxel: the first `max_points_per_voxel` of each, original
// points. Points of `critical` classes that come when a voxel is full
// stay nonetheless, up to `max_critical_points_per_voxel` more. Positions must be finite.
// Intensities and times are not kept.
//
// The result is ordered by a spatial hash of the voxels. A further sub-sampling and the local map
// prefer what comes first, and the order of a scan would make them prefer one side of everything;
// the hash has no direction. It is also the order of KISS-ICP, whose poses come out the same.
// Source: KISS-ICP, section III-B; the paper's exception for critical classes.
cartographer::sensor::LabeledPointCloud Subsample(
    const cartographer::sensor::LabeledPointCloud& cloud, const proto::SubsamplingOptions& options,
    const cartographer::sensor::LabelMask& critical);

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_VOXEL_SUBSAMPLING_H_
