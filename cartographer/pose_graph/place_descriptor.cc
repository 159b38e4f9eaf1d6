// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_descriptor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cartographer/common/status.h"

namespace cartographer::pose_graph {
namespace {

// Polar cells are four times finer than the shortest harmonic.
constexpr int kSectorsPerHarmonic = 4;

scan_matching::proto::ScoreOptions GroupsAsScore(const proto::PlaceRecognitionOptions& options) {
  scan_matching::proto::ScoreOptions score;
  score.set_score("max_layer");
  score.set_max_range_m(options.radius_m());
  *score.mutable_groups() = options.groups();
  return score;
}

// Coefficients 1, ..., num_harmonics of a row of sectors: sum over s of a_s exp(-i k theta_s).
void Transform(const float* sectors, int num_sectors, const std::vector<float>& cosines,
               const std::vector<float>& sines, int num_harmonics, float* coefficients) {
  for (int k = 1; k <= num_harmonics; ++k) {
    float real = 0.f, imaginary = 0.f;
    for (int s = 0, turn = 0; s < num_sectors; ++s, turn = (turn + k) % num_sectors) {
      real += sectors[s] * cosines[turn];
      imaginary -= sectors[s] * sines[turn];
    }
    coefficients[2 * k - 2] = real;
    coefficients[2 * k - 1] = imaginary;
  }
}

}  // namespace

absl::StatusOr<PlaceDescriber> PlaceDescriber::Create(const proto::PlaceRecognitionOptions& options,
                                                      const sensor::LabelSet& labels) {
  ASSIGN_OR_RETURN(scan_matching::ScoreModel model,
                   scan_matching::ScoreModel::Create(GroupsAsScore(options), labels));
  PlaceDescriber describer(options, std::move(model));
  for (size_t i = 0; i < labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    const int layer = describer.model_.LayerOf(label);
    if (layer == scan_matching::ScoreModel::kNotMatched) continue;
    const int channel = describer.model_.GroupOf(layer);
    describer.weights_[channel] = static_cast<float>(describer.model_.WeightOf(label)) /
                                  scan_matching::ScoreModel::kWeightSteps;
    describer.saturations_[channel] = static_cast<float>(describer.model_.SaturationOf(layer));
  }
  return describer;
}

PlaceDescriber::PlaceDescriber(const proto::PlaceRecognitionOptions& options,
                               scan_matching::ScoreModel model)
    : model_(std::move(model)),
      num_channels_(model_.num_groups()),
      num_rings_(options.num_rings()),
      num_harmonics_(options.num_harmonics()),
      radius_m_(options.radius_m()),
      weights_(num_channels_),
      saturations_(num_channels_) {}

void PlaceDescriber::AddPoints(const Part& part, const Eigen::Vector2d& center,
                               std::vector<float>* amounts) const {
  const int num_sectors = kSectorsPerHarmonic * num_harmonics_;
  const auto rings_per_m = static_cast<float>(num_rings_ / radius_m_);
  const auto sectors_per_rad = static_cast<float>(num_sectors / (2. * M_PI));
  Eigen::Matrix<double, 2, 4> plane_from_cloud = part.frame_from_cloud.Matrix().topRows<2>();
  plane_from_cloud.col(3) -= center;
  const Eigen::Matrix<float, 2, 4> local_from_cloud = plane_from_cloud.cast<float>();
  for (size_t i = 0; i < part.cloud.size(); ++i) {
    const int layer = model_.LayerOf(part.cloud.labels[i]);
    if (layer == scan_matching::ScoreModel::kNotMatched) continue;
    const Eigen::Vector2f point =
        local_from_cloud.leftCols<3>() * part.cloud.positions[i] + local_from_cloud.col(3);
    const float ring = point.norm() * rings_per_m;
    // Written so that what is not a number is out of range, too.
    if (!(ring < static_cast<float>(num_rings_))) continue;
    const float bearing = std::atan2(point.y(), point.x()) * sectors_per_rad;
    const int sector = (static_cast<int>(std::floor(bearing)) + num_sectors) % num_sectors;
    const int row = model_.GroupOf(layer) * num_rings_ + static_cast<int>(ring);
    (*amounts)[row * num_sectors + sector] += 1.f;
  }
}

PlaceDescriptor PlaceDescriber::Describe(const std::vector<Part>& parts,
                                         const Eigen::Vector2d& center) const {
  PlaceDescriptor result;
  result.center = center;
  const int num_sectors = kSectorsPerHarmonic * num_harmonics_;
  std::vector<float> amounts(num_rows() * num_sectors, 0.f);
  for (const Part& part : parts) AddPoints(part, center, &amounts);
  const double ring_m = radius_m_ / num_rings_;
  std::vector<float> cosines(num_sectors), sines(num_sectors);
  for (int s = 0; s < num_sectors; ++s) {
    cosines[s] = static_cast<float>(std::cos(2. * M_PI * s / num_sectors));
    sines[s] = static_cast<float>(std::sin(2. * M_PI * s / num_sectors));
  }
  std::vector<float> coefficients(2 * num_rows() * num_harmonics_);
  for (int row = 0; row < num_rows(); ++row) {
    const int channel = row / num_rings_, ring = row % num_rings_;
    const auto area_m2 = static_cast<float>(M_PI * ring_m * ring_m * (2 * ring + 1) / num_sectors);
    for (int s = 0; s < num_sectors; ++s) {
      float& amount = amounts[row * num_sectors + s];
      amount =
          weights_[channel] * area_m2 * std::min(1.f, amount / (area_m2 * saturations_[channel]));
    }
    Transform(&amounts[row * num_sectors], num_sectors, cosines, sines, num_harmonics_,
              &coefficients[2 * row * num_harmonics_]);
  }
  float squared_norm = 0.f;
  for (const float c : coefficients) squared_norm += c * c;
  if (squared_norm == 0.f) return result;
  const float scale = 1.f / std::sqrt(squared_norm);
  for (float& c : coefficients) c *= scale;
  result.coefficients = std::move(coefficients);
  return result;
}

}  // namespace cartographer::pose_graph
