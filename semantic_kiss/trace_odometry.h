// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_TRACE_ODOMETRY_H_
#define SEMANTIC_KISS_TRACE_ODOMETRY_H_

#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/scan_trace.h"
#include "semantic_kiss/odometry/odometry.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss {

// Appends what the odometry made of a scan: "deskew", "range", "moving", "map voxels",
// "icp voxels", "prediction", "registration", "pose", "local map".
void TraceOdometry(const cartographer::sensor::LabeledPointCloud& scan,
                   const odometry::OdometryReport& report,
                   const odometry::proto::OdometryOptions& options,
                   cartographer::slam::ScanTrace* trace);

}  // namespace semantic_kiss

#endif  // SEMANTIC_KISS_TRACE_ODOMETRY_H_
