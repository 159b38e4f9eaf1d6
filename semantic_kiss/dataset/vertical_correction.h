// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_VERTICAL_CORRECTION_H_
#define SEMANTIC_KISS_DATASET_VERTICAL_CORRECTION_H_

#include <Eigen/Core>
#include <vector>

namespace semantic_kiss::dataset {

// Raises the elevation of every point, seen from the origin (the sensor; z is up), by `angle_rad`.
// Range and azimuth stay. A point on the z axis has no azimuth and stays where it is; NaN remains
// NaN.
//
// In the vertical plane through a point, with h its distance from the z axis, this is the rotation
//   h' = h cos(a) - z sin(a),   z' = h sin(a) + z cos(a),
// and x and y shrink or grow as h does.
void RaiseElevation(double angle_rad, std::vector<Eigen::Vector3f>* points);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_VERTICAL_CORRECTION_H_
