// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_VOXEL_FILTER_H_
#define CARTOGRAPHER_REGISTRATION_VOXEL_FILTER_H_

#include "cartographer/sensor/labeled_point_cloud.h"

namespace cartographer::registration {

// The first point of every voxel of side `voxel_size_m` (> 0, CHECKed), in their order. Positions
// must be finite.
sensor::LabeledPointCloud FilterByVoxel(const sensor::LabeledPointCloud& cloud,
                                        double voxel_size_m);

// FilterByVoxel() with the largest voxels, up to `max_voxel_size_m`, that leave `min_points` points
// or more, to a tenth of their size; the cloud itself if it has no more than that.
// Source: the adaptive voxel filter of Cartographer.
sensor::LabeledPointCloud FilterDownTo(const sensor::LabeledPointCloud& cloud, int min_points,
                                       double max_voxel_size_m);

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_VOXEL_FILTER_H_
