// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/height_band.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace cartographer::slam {
namespace {

TEST(HeightBandTest, KeepsWhatIsInRangeAndInTheBand) {
  proto::HeightBandOptions options;
  options.set_min_range_m(2.);
  options.set_max_range_m(50.);
  options.set_min_z_m(-1.);
  options.set_max_z_m(2.);
  options.set_voxel_size_m(0.1);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  sensor::LabeledPointCloud scan;
  for (const Eigen::Vector3f& position :
       std::vector<Eigen::Vector3f>{{10.f, 0.f, 0.f},      // kept
                                    {10.f, 0.f, -1.1f},    // ground
                                    {10.f, 0.f, 2.1f},     // a bridge
                                    {1.f, 0.f, 0.f},       // the car itself
                                    {60.f, 0.f, 0.f},      // too far
                                    {10.f, kNan, 0.f},     //
                                    {10.f, 0.f, kNan},     //
                                    {10.01f, 0.f, 0.f},    // same voxel as the first
                                    {0.f, -20.f, 2.f}}) {  // kept
    scan.positions.push_back(position);
    scan.labels.push_back(sensor::Label{static_cast<uint8_t>(scan.size())});
    scan.certainties.push_back(0.5f);
  }
  const sensor::LabeledPointCloud band = CutHeightBand(scan, options);
  EXPECT_EQ(band.labels, (std::vector<sensor::Label>{sensor::Label{1}, sensor::Label{9}}));
  EXPECT_EQ(band.positions[1], Eigen::Vector3f(0.f, -20.f, 2.f));
  EXPECT_TRUE(CutHeightBand({}, options).empty());
}

}  // namespace
}  // namespace cartographer::slam
