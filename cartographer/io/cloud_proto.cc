// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/cloud_proto.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/sensor/compressed_point_cloud.h"

namespace cartographer::io {
namespace {

constexpr float kFractionSteps = 255.f;
constexpr double kTicksPerSecond = 1e6;
constexpr double kMaxTime_s = 1000.;

// Numbers in [0, 1] as bytes, rearranged by `order`.
absl::Status PackFractions(const std::vector<float>& values, const char* name,
                           const std::vector<uint32_t>& order, std::string* bytes) {
  if (values.empty()) return absl::OkStatus();
  bytes->reserve(order.size());
  for (const uint32_t i : order) {
    if (!(values[i] >= 0.f && values[i] <= 1.f)) {
      return absl::InvalidArgumentError(
          absl::StrCat("point ", i, ": ", name, " ", values[i], " is not in [0, 1]"));
    }
    bytes->push_back(static_cast<char>(std::lround(values[i] * kFractionSteps)));
  }
  return absl::OkStatus();
}

std::vector<float> UnpackFractions(const std::string& bytes) {
  std::vector<float> values;
  values.reserve(bytes.size());
  for (const char byte : bytes) values.push_back(static_cast<uint8_t>(byte) / kFractionSteps);
  return values;
}

absl::Status PackLabels(const std::vector<sensor::Label>& labels, size_t num_labels,
                        const std::vector<uint32_t>& order, std::string* bytes) {
  bytes->reserve(order.size());
  for (const uint32_t i : order) {
    if (sensor::Index(labels[i]) >= num_labels) {
      return absl::InvalidArgumentError(absl::StrCat(
          "point ", i, ": label ", sensor::Index(labels[i]), " is not in the set of ", num_labels));
    }
    bytes->push_back(static_cast<char>(labels[i]));
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<sensor::Label>> UnpackLabels(const std::string& bytes,
                                                        size_t num_labels) {
  std::vector<sensor::Label> labels;
  labels.reserve(bytes.size());
  for (const char byte : bytes) {
    labels.push_back(sensor::Label{static_cast<uint8_t>(byte)});
    if (sensor::Index(labels.back()) >= num_labels) {
      return absl::DataLossError(absl::StrCat("point ", labels.size() - 1, ": label ",
                                              sensor::Index(labels.back()),
                                              " is not in the set of ", num_labels));
    }
  }
  return labels;
}

absl::Status PackTimes(const std::vector<float>& times, const std::vector<uint32_t>& order,
                       map::proto::PointAttributes* attributes) {
  if (times.empty()) return absl::OkStatus();
  for (const uint32_t i : order) {
    if (!(std::abs(times[i]) <= kMaxTime_s)) {
      return absl::InvalidArgumentError(
          absl::StrCat("point ", i, ": time ", times[i], " s is not within +-1000 s"));
    }
    attributes->add_times_us(static_cast<int>(std::lround(times[i] * kTicksPerSecond)));
  }
  return absl::OkStatus();
}

absl::Status CheckColumns(const map::proto::PointAttributes& attributes, size_t num_points) {
  const auto fits = [num_points](size_t size, bool optional) {
    return size == num_points || (optional && size == 0);
  };
  if (fits(attributes.labels().size(), false) && fits(attributes.certainties().size(), false) &&
      fits(attributes.intensities().size(), true) && fits(attributes.times_us_size(), true)) {
    return absl::OkStatus();
  }
  return absl::DataLossError(absl::StrCat(
      num_points, " points, but ", attributes.labels().size(), " labels, ",
      attributes.certainties().size(), " certainties, ", attributes.intensities().size(),
      " intensities and ", attributes.times_us_size(), " times"));
}

absl::Status UnpackAttributes(const map::proto::PointAttributes& attributes, size_t num_labels,
                              sensor::LabeledPointCloud* cloud) {
  RETURN_IF_ERROR(CheckColumns(attributes, cloud->size()));
  ASSIGN_OR_RETURN(cloud->labels, UnpackLabels(attributes.labels(), num_labels));
  cloud->certainties = UnpackFractions(attributes.certainties());
  cloud->intensities = UnpackFractions(attributes.intensities());
  cloud->times.reserve(attributes.times_us_size());
  for (const int time_us : attributes.times_us()) {
    cloud->times.push_back(static_cast<float>(time_us / kTicksPerSecond));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<CloudProto> ToProto(const sensor::LabeledPointCloud& cloud, size_t num_labels,
                                   const Eigen::Quaterniond& stored_from_cloud) {
  cloud.CheckConsistent();
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(cloud.size());
  const Eigen::Matrix3d rotation = stored_from_cloud.toRotationMatrix();
  for (const Eigen::Vector3f& position : cloud.positions) {
    positions.push_back(rotation * position.cast<double>());
  }
  ASSIGN_OR_RETURN(sensor::CompressedPositions compressed, sensor::CompressPositions(positions));
  CloudProto result;
  result.positions = std::move(compressed.proto);
  const std::vector<uint32_t>& order = compressed.order;
  map::proto::PointAttributes& attributes = result.attributes;
  RETURN_IF_ERROR(PackLabels(cloud.labels, num_labels, order, attributes.mutable_labels()));
  RETURN_IF_ERROR(
      PackFractions(cloud.certainties, "certainty", order, attributes.mutable_certainties()));
  RETURN_IF_ERROR(
      PackFractions(cloud.intensities, "intensity", order, attributes.mutable_intensities()));
  RETURN_IF_ERROR(PackTimes(cloud.times, order, &attributes));
  return result;
}

absl::StatusOr<sensor::LabeledPointCloud> FromProto(
    const sensor::proto::CompressedPointCloud& positions,
    const map::proto::PointAttributes* attributes, size_t num_labels,
    const Eigen::Quaterniond& stored_from_cloud) {
  ASSIGN_OR_RETURN(const std::vector<Eigen::Vector3d> stored,
                   sensor::DecompressPositions(positions));
  sensor::LabeledPointCloud cloud;
  cloud.Reserve(stored.size());
  const Eigen::Matrix3d rotation = stored_from_cloud.conjugate().toRotationMatrix();
  for (const Eigen::Vector3d& position : stored) {
    cloud.positions.push_back((rotation * position).cast<float>());
  }
  if (attributes == nullptr) {
    cloud.labels.assign(cloud.size(), sensor::kUnlabeled);
    cloud.certainties.assign(cloud.size(), 1.f);
  } else {
    RETURN_IF_ERROR(UnpackAttributes(*attributes, num_labels, &cloud));
  }
  return cloud;
}

}  // namespace cartographer::io
