// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_POINT_FILE_H_
#define SEMANTIC_KISS_DATASET_POINT_FILE_H_

#include <cstddef>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "semantic_kiss/dataset/file_buffer.h"

namespace semantic_kiss::dataset {

// Reads the points of a scan, float32 x, y, z [m] and remission each, by way of `buffer`, into the
// positions and intensities of `cloud` (replaced; its other columns are left alone). Values are
// taken as they are, NaN and infinity included; a file of 0 bytes is a scan without points. Fails
// if the size of the file is not a multiple of 16 bytes.
absl::Status ReadPoints(const std::string& path, FileBuffer* buffer,
                        cartographer::sensor::LabeledPointCloud* cloud);

// Reads the times of the `num_points` points of a scan, a float32 each: seconds relative to the
// scan's time stamp, which is the end of the sweep, hence in [-1, 0] (a lidar at 10 Hz: [-0.1, 0]).
// Fails for any other value, and for any other number of values.
absl::Status ReadPointTimes(const std::string& path, size_t num_points, FileBuffer* buffer,
                            std::vector<float>* times);

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_POINT_FILE_H_
