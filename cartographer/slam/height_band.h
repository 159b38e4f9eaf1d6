// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_HEIGHT_BAND_H_
#define CARTOGRAPHER_SLAM_HEIGHT_BAND_H_

#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/proto/planar_builder_options.pb.h"

namespace cartographer::slam {

// What a builder in the plane sees of a scan: points in range and in a band of heights above the
// sensor, which must be level, so that neither the ground nor what cars drive under is an obstacle;
// one in each voxel. Points that are not finite are dropped, and so are intensities and times.
sensor::LabeledPointCloud CutHeightBand(const sensor::LabeledPointCloud& scan,
                                        const proto::HeightBandOptions& options);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_HEIGHT_BAND_H_
