// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SENSOR_COMPRESSED_POINT_CLOUD_H_
#define CARTOGRAPHER_SENSOR_COMPRESSED_POINT_CLOUD_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/sensor/proto/sensor.pb.h"

namespace cartographer::sensor {

// Positions rounded to 1 mm in the form that Cartographer's maps hold: see CompressedPointCloud in
// sensor.proto. Compressing what was decompressed gives the same message: rounding happens once.
// This holds for float positions, too, and after a rotation to another frame and back.

struct CompressedPositions {
  proto::CompressedPointCloud proto;
  // order[i] is the index in the input of the i-th point of `proto`: points are sorted by block
  // (ascending z, y, x) and keep their order within one. What goes with the points must be
  // rearranged alike.
  std::vector<uint32_t> order;
};

// `positions` [m]. A coordinate that is not finite or 8388.607 m or more from 0 is an error.
absl::StatusOr<CompressedPositions> CompressPositions(
    const std::vector<Eigen::Vector3d>& positions);

// Positions [m] in the message's order. Errors name the point: blocks that run over the end, counts
// that do not add up, indices out of the range above.
absl::StatusOr<std::vector<Eigen::Vector3d>> DecompressPositions(
    const proto::CompressedPointCloud& proto);

}  // namespace cartographer::sensor

#endif  // CARTOGRAPHER_SENSOR_COMPRESSED_POINT_CLOUD_H_
