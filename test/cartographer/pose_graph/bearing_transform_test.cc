// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/bearing_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace cartographer::pose_graph {
namespace {

using Values = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Values RandomValues(int num_rows, const BearingTransform& transform, std::mt19937* random) {
  Values values(num_rows, transform.num_bearings());
  std::uniform_real_distribution<float> amount(-1.f, 1.f);
  for (float& value : values.reshaped()) value = amount(*random);
  return values;
}

// Coefficient k >= 1 of a row, from the definition.
std::complex<double> PlainCoefficient(const Values& values, int row, int k) {
  std::complex<double> sum = 0.;
  for (int i = 0; i < values.cols(); ++i) {
    sum += std::polar<double>(values(row, i), -2. * M_PI * k * i / values.cols());
  }
  return sum;
}

// Agreement at one heading: query turned by it, times target, from the definition.
double PlainAgreement(const Values& query, const Values& target, int num_harmonics, double yaw) {
  double sum = 0.;
  for (int row = 0; row < query.rows(); ++row) {
    for (int k = 1; k <= num_harmonics; ++k) {
      sum += std::real(PlainCoefficient(target, row, k) *
                       std::conj(PlainCoefficient(query, row, k) * std::polar(1., -k * yaw)));
    }
  }
  return sum;
}

TEST(BearingTransformTest, AgreesWithTheDefinition) {
  std::mt19937 random(1);
  for (const int num_harmonics : {1, 3, 4, 8, 13}) {
    const BearingTransform transform(num_harmonics);
    const Values query = RandomValues(5, transform, &random);
    const Values target = RandomValues(5, transform, &random);
    double best = -1e9, best_yaw = 0.;
    for (int h = 0; h < 8 * num_harmonics; ++h) {
      const double yaw = 2. * M_PI * h / (8 * num_harmonics);
      const double agreement = PlainAgreement(query, target, num_harmonics, yaw);
      if (agreement > best) {
        best = agreement;
        best_yaw = yaw;
      }
    }
    const auto found =
        transform.FindBestHeading(transform.Transform(query), transform.Transform(target));
    EXPECT_NEAR(found.score, best, 1e-3 * std::abs(best)) << num_harmonics;
    // Refined by at most half a step.
    EXPECT_LE(std::abs(std::remainder(found.yaw_rad - best_yaw, 2. * M_PI)),
              M_PI / (8 * num_harmonics) + 1e-6)
        << num_harmonics;
    EXPECT_LE(std::abs(found.yaw_rad), M_PI);
  }
}

TEST(BearingTransformTest, FindsHowFarTheValuesWereTurned) {
  const BearingTransform transform(8);
  const int num_bearings = transform.num_bearings();
  // A function of the bearing that the harmonics can hold.
  const auto amount = [](int row, double bearing) {
    return std::cos(bearing - row) + 0.7 * std::sin(3. * bearing + 2 * row) +
           0.5 * std::cos(7. * bearing);
  };
  const auto turned_by = [&](double yaw) {
    Values values(3, num_bearings);
    for (int row = 0; row < 3; ++row) {
      for (int i = 0; i < num_bearings; ++i) {
        values(row, i) = static_cast<float>(amount(row, 2. * M_PI * i / num_bearings - yaw));
      }
    }
    return transform.Transform(values);
  };
  const double whole = transform.FindBestHeading(turned_by(0.), turned_by(0.)).score;
  for (int degrees = -180; degrees <= 180; degrees += 7) {
    const double yaw = degrees * M_PI / 180.;
    const auto found = transform.FindBestHeading(turned_by(0.3), turned_by(0.3 + yaw));
    EXPECT_NEAR(std::remainder(found.yaw_rad - yaw, 2. * M_PI), 0., 0.5 * M_PI / 180.) << degrees;
    EXPECT_NEAR(found.score, whole, 0.05 * whole) << degrees;
  }
}

TEST(BearingTransformTest, LeavesTheMeanOut) {
  const BearingTransform transform(4);
  const auto spectrum = transform.Transform(Values::Constant(2, transform.num_bearings(), 3.f));
  EXPECT_NEAR(transform.FindBestHeading(spectrum, spectrum).score, 0., 1e-6);
}

}  // namespace
}  // namespace cartographer::pose_graph
