// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_CLOUD_PROTO_H_
#define CARTOGRAPHER_IO_CLOUD_PROTO_H_

#include <Eigen/Geometry>

#include "absl/status/statusor.h"
#include "cartographer/map/proto/semantic_map.pb.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/sensor/proto/sensor.pb.h"

namespace cartographer::io {

// A labeled cloud as maps hold it: positions in Cartographer's message, all else beside them, in
// the same order. Quantized once: positions to 1 mm, certainties and intensities to 1/255, times
// to 1 us; what was read is written again byte by byte.
struct CloudProto {
  sensor::proto::CompressedPointCloud positions;
  map::proto::PointAttributes attributes;
};

// `stored_from_cloud` turns the positions into the frame in which they are stored. Points are
// sorted by place (compressed_point_cloud.h). Errors name the point and what cannot be stored:
// positions beyond 8388 m, certainties or intensities outside [0, 1], times beyond 1000 s, labels
// not below `num_labels`.
absl::StatusOr<CloudProto> ToProto(const sensor::LabeledPointCloud& cloud, size_t num_labels,
                                   const Eigen::Quaterniond& stored_from_cloud);

// The reverse. Without `attributes` (nullptr), as in Cartographer's own maps, all points are
// unlabeled with certainty 1.
absl::StatusOr<sensor::LabeledPointCloud> FromProto(
    const sensor::proto::CompressedPointCloud& positions,
    const map::proto::PointAttributes* attributes, size_t num_labels,
    const Eigen::Quaterniond& stored_from_cloud);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_CLOUD_PROTO_H_
