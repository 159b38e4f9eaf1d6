// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_SUBMAP_ONE_POINT_H_
#define TEST_CARTOGRAPHER_SUBMAP_ONE_POINT_H_

#include "cartographer/sensor/labeled_point_cloud.h"

namespace cartographer::submap {

inline sensor::LabeledPointCloud OnePoint(const Eigen::Vector3f& position, sensor::Label label) {
  sensor::LabeledPointCloud cloud;
  cloud.positions.push_back(position);
  cloud.labels.push_back(label);
  cloud.certainties.push_back(1.f);
  return cloud;
}

}  // namespace cartographer::submap

#endif  // TEST_CARTOGRAPHER_SUBMAP_ONE_POINT_H_
