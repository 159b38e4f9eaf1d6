// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/vertical_correction.h"

#include <cmath>

namespace semantic_kiss::dataset {

void RaiseElevation(double angle_rad, std::vector<Eigen::Vector3f>* points) {
  // Single precision keeps 0.1 um/m. The plain loop is as fast as blocks of vector instructions:
  // the root and the quotient of neighbouring points overlap in the pipeline.
  const float sine = static_cast<float>(std::sin(angle_rad));
  const float cosine = static_cast<float>(std::cos(angle_rad));
  for (Eigen::Vector3f& point : *points) {
    const float distance = std::sqrt(point.x() * point.x() + point.y() * point.y());
    if (distance == 0.f) continue;
    const float scale = cosine - sine * (point.z() / distance);
    point =
        Eigen::Vector3f(point.x() * scale, point.y() * scale, sine * distance + cosine * point.z());
  }
}

}  // namespace semantic_kiss::dataset
