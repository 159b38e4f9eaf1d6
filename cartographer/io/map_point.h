// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_POINT_H_
#define CARTOGRAPHER_IO_MAP_POINT_H_

#include <Eigen/Core>

#include "cartographer/sensor/label.h"

namespace cartographer::io {

// A point of a map as point cloud files hold it.
struct MapPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  // [m], map frame
  float certainty = 1.f;
  float intensity = 0.f;  // 0 where nothing is known of it
  sensor::Label label = sensor::kUnlabeled;
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_POINT_H_
