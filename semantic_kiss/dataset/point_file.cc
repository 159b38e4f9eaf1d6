// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/point_file.h"

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::dataset {
namespace {

constexpr size_t kValuesPerPoint = 4;
constexpr size_t kBytesPerPoint = kValuesPerPoint * sizeof(float);
constexpr float kLongestSweep_s = 1.f;

}  // namespace

absl::Status ReadPoints(const std::string& path, FileBuffer* buffer,
                        cartographer::sensor::LabeledPointCloud* cloud) {
  RETURN_IF_ERROR(buffer->Read(path));
  if (buffer->size() % kBytesPerPoint != 0) {
    return absl::InvalidArgumentError(absl::StrCat(
        path, ": size is ", buffer->size(), " bytes, not a multiple of ", kBytesPerPoint,
        "; points are float32 x, y, z, remission. Is the file cut off, or another format?"));
  }
  const size_t num_points = buffer->size() / kBytesPerPoint;
  cloud->positions.resize(num_points);
  cloud->intensities.resize(num_points);
  const float* values = buffer->As<float>();
  for (size_t i = 0; i < num_points; ++i, values += kValuesPerPoint) {
    cloud->positions[i] = Eigen::Vector3f(values[0], values[1], values[2]);
    cloud->intensities[i] = values[3];
  }
  return absl::OkStatus();
}

absl::Status ReadPointTimes(const std::string& path, size_t num_points, FileBuffer* buffer,
                            std::vector<float>* times) {
  RETURN_IF_ERROR(buffer->Read(path));
  if (buffer->size() != num_points * sizeof(float)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": size is ", buffer->size(), " bytes; for a scan of ", num_points,
                     " points it is ", num_points * sizeof(float), ", a float32 a point"));
  }
  const float* const values = buffer->As<float>();
  times->assign(values, values + num_points);
  for (size_t i = 0; i < num_points; ++i) {
    if (!(values[i] >= -kLongestSweep_s && values[i] <= 0.f)) {
      return absl::InvalidArgumentError(absl::StrCat(
          path, ": time of point ", i, " is ", values[i],
          ", which is not in [-1, 0]; times are seconds relative to the end of the sweep"));
    }
  }
  return absl::OkStatus();
}

}  // namespace semantic_kiss::dataset
