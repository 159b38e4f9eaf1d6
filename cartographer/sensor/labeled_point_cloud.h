// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SENSOR_LABELED_POINT_CLOUD_H_
#define CARTOGRAPHER_SENSOR_LABELED_POINT_CLOUD_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/common/time.h"
#include "cartographer/sensor/label.h"

namespace cartographer::sensor {

// N points as a structure of arrays. `positions`, `labels` and `certainties` have N entries each;
// `intensities` and `times` have N entries or none.
struct LabeledPointCloud {
  std::vector<Eigen::Vector3f> positions;  // [m]
  std::vector<Label> labels;               // kUnlabeled where nothing is known
  std::vector<float> certainties;          // P(label | input), in [0, 1]
  std::vector<float> intensities;          // remission, in [0, 1]
  std::vector<float> times;                // [s], relative to the scan's time stamp

  size_t size() const { return positions.size(); }
  bool empty() const { return positions.empty(); }
  void Reserve(size_t size);
  void Clear();

  // Appends point `index` of `other` with all the columns that `other` has. Mixing clouds with and
  // without an optional column is a bug (CHECKed by CheckConsistent()).
  void Append(const LabeledPointCloud& other, size_t index);

  // CHECK-fails unless the columns have the sizes stated above.
  void CheckConsistent() const;
};

// The points whose label is not in `dropped`, in their order.
LabeledPointCloud WithoutLabels(const LabeledPointCloud& cloud, const LabelMask& dropped);

// One sweep of the lidar: x forward, y left, z up, in the sensor's frame at `time`.
struct LabeledScan {
  int index = 0;      // number of the scan in its sequence
  common::Time time;  // end of the sweep
  LabeledPointCloud points;
};

}  // namespace cartographer::sensor

#endif  // CARTOGRAPHER_SENSOR_LABELED_POINT_CLOUD_H_
