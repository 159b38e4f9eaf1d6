// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/labeled_point_cloud.h"

#include "glog/logging.h"

namespace cartographer::sensor {

void LabeledPointCloud::Reserve(size_t size) {
  positions.reserve(size);
  labels.reserve(size);
  certainties.reserve(size);
}

void LabeledPointCloud::Clear() {
  positions.clear();
  labels.clear();
  certainties.clear();
  intensities.clear();
  times.clear();
}

void LabeledPointCloud::Append(const LabeledPointCloud& other, size_t index) {
  positions.push_back(other.positions[index]);
  labels.push_back(other.labels[index]);
  certainties.push_back(other.certainties[index]);
  if (!other.intensities.empty()) intensities.push_back(other.intensities[index]);
  if (!other.times.empty()) times.push_back(other.times[index]);
}

void LabeledPointCloud::CheckConsistent() const {
  CHECK_EQ(labels.size(), size());
  CHECK_EQ(certainties.size(), size());
  CHECK(intensities.empty() || intensities.size() == size());
  CHECK(times.empty() || times.size() == size());
}

LabeledPointCloud WithoutLabels(const LabeledPointCloud& cloud, const LabelMask& dropped) {
  LabeledPointCloud kept;
  kept.Reserve(cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!dropped.Contains(cloud.labels[i])) kept.Append(cloud, i);
  }
  return kept;
}

}  // namespace cartographer::sensor
