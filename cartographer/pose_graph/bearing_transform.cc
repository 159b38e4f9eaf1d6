// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/bearing_transform.h"

#include <algorithm>
#include <cmath>

#include "cartographer/pose_graph/parabola.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

// Fine enough that the best heading is hardly ever missed by more than a tenth of a harmonic.
constexpr int kHeadingsPerHarmonic = 8;
constexpr int kBearingsPerHarmonic = 4;
constexpr int kMaxHeadings = kHeadingsPerHarmonic * BearingTransform::kMaxHarmonics;
constexpr int kLanes = 4;

int NumBlocks(int num_harmonics) { return (num_harmonics + kLanes - 1) / kLanes; }

}  // namespace

BearingTransform::BearingTransform(int num_harmonics)
    : num_harmonics_(num_harmonics),
      num_bearings_(kBearingsPerHarmonic * num_harmonics),
      num_headings_(kHeadingsPerHarmonic * num_harmonics) {
  CHECK_GT(num_harmonics, 0);
  CHECK_LE(num_harmonics, kMaxHarmonics);
  const auto fill = [&](int num_angles, int num_columns, Table* cosines, Table* sines) {
    cosines->resize(num_harmonics, num_columns);
    sines->resize(num_harmonics, num_columns);
    for (int k = 0; k < num_harmonics; ++k) {
      for (int i = 0; i < num_columns; ++i) {
        const double angle = 2. * M_PI * (k + 1) * i / num_angles;
        (*cosines)(k, i) = static_cast<float>(std::cos(angle));
        (*sines)(k, i) = static_cast<float>(std::sin(angle));
      }
    }
  };
  fill(num_bearings_, num_bearings_, &bearing_cosines_, &bearing_sines_);
  fill(num_headings_, num_headings_ / 4 + 1, &heading_cosines_, &heading_sines_);
}

BearingSpectrum BearingTransform::Transform(const Table& values) const {
  CHECK_EQ(values.cols(), num_bearings_);
  const auto num_rows = values.rows();
  const int num_blocks = NumBlocks(num_harmonics_);
  BearingSpectrum spectrum;
  spectrum.harmonics.resize(num_blocks * num_rows,
                            {Eigen::Array4f::Zero(), Eigen::Array4f::Zero()});
  const Eigen::MatrixXf real = values.matrix() * bearing_cosines_.matrix().transpose();
  const Eigen::MatrixXf imaginary = values.matrix() * bearing_sines_.matrix().transpose();
  for (int row = 0; row < num_rows; ++row) {
    for (int k = 0; k < num_harmonics_; ++k) {
      auto& harmonics = spectrum.harmonics[k / kLanes * num_rows + row];
      harmonics.real[k % kLanes] = real(row, k);
      harmonics.imaginary[k % kLanes] = -imaginary(row, k);
    }
  }
  return spectrum;
}

BearingTransform::Product BearingTransform::Multiply(const BearingSpectrum& query,
                                                     const BearingSpectrum& target) const {
  const int num_blocks = NumBlocks(num_harmonics_);
  const size_t num_rows = query.harmonics.size() / num_blocks;
  Product product;
  for (int block = 0; block < num_blocks; ++block) {
    const auto* const q = query.harmonics.data() + block * num_rows;
    const auto* const t = target.harmonics.data() + block * num_rows;
    Eigen::Array4f real = Eigen::Array4f::Zero(), imaginary = Eigen::Array4f::Zero();
    for (size_t row = 0; row < num_rows; ++row) {
      real += t[row].real * q[row].real + t[row].imaginary * q[row].imaginary;
      imaginary += t[row].imaginary * q[row].real - t[row].real * q[row].imaginary;
    }
    Eigen::Map<Eigen::Array4f>(product.real + kLanes * block) = real;
    Eigen::Map<Eigen::Array4f>(product.imaginary + kLanes * block) = imaginary;
  }
  return product;
}

BearingTransform::Agreement BearingTransform::FindBestHeading(const BearingSpectrum& query,
                                                              const BearingSpectrum& target) const {
  DCHECK_EQ(query.harmonics.size(), target.harmonics.size());
  const Product product = Multiply(query, target);
  // At heading h the sum over k of real cos(k h) - imaginary sin(k h). Even and odd harmonics,
  // cosines and sines apart give the other three quarters of the turn by their signs.
  using Quarter = Eigen::Array<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxHeadings / 4 + 1, 1>;
  const int quarter = num_headings_ / 4;
  Quarter cosines[2] = {Quarter::Zero(quarter + 1), Quarter::Zero(quarter + 1)};
  Quarter sines[2] = {Quarter::Zero(quarter + 1), Quarter::Zero(quarter + 1)};
  for (int k = 0; k < num_harmonics_; ++k) {
    const int odd = (k + 1) % 2;
    cosines[odd] += product.real[k] * heading_cosines_.row(k).transpose();
    sines[odd] += product.imaginary[k] * heading_sines_.row(k).transpose();
  }
  Eigen::Array<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxHeadings, 1> scores(num_headings_);
  for (int h = 0; h <= quarter; ++h) {
    const float even_part = cosines[0][h], odd_part = cosines[1][h];
    const float even_turn = sines[0][h], odd_turn = sines[1][h];
    scores[h] = (even_part + odd_part) - (even_turn + odd_turn);
    scores[2 * quarter - h] = (even_part - odd_part) + (even_turn - odd_turn);
    scores[2 * quarter + h] = (even_part - odd_part) - (even_turn - odd_turn);
    scores[(num_headings_ - h) % num_headings_] = (even_part + odd_part) + (even_turn + odd_turn);
  }
  int best = 0;
  const float score = scores.maxCoeff(&best);
  const double step = TopOfParabola(scores[(best + num_headings_ - 1) % num_headings_], score,
                                    scores[(best + 1) % num_headings_]);
  return {std::remainder(2. * M_PI * (best + step) / num_headings_, 2. * M_PI), score};
}

}  // namespace cartographer::pose_graph
