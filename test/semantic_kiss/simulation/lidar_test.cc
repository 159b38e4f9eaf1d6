// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/lidar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

Lidar SmallLidar(const std::string& overrides, uint64_t seed = 1) {
  const proto::SimulationOptions options = SmallOptions(overrides);
  return Lidar(options.lidars(0), options.errors(), seed);
}

TEST(LidarTest, BeamsSpreadFromTopToBottomAndTurnLeft) {
  const Lidar lidar = SmallLidar(kNoErrors);
  ASSERT_EQ(lidar.beams(), 16);
  EXPECT_NEAR(lidar.Nominal(0, 0).elevation, 2. * M_PI / 180., 1e-9);
  EXPECT_NEAR(lidar.Nominal(15, 0).elevation, -24. * M_PI / 180., 1e-9);
  EXPECT_NEAR(lidar.NominalAzimuth(0), -M_PI, 0.02);
  EXPECT_NEAR(lidar.NominalAzimuth(150), 0., 0.02);
  EXPECT_NEAR(lidar.NominalAzimuth(225), M_PI / 2., 0.02);
  const Eigen::Vector3d left = Bearing{0., M_PI / 2.}.Direction();
  EXPECT_NEAR((left - Eigen::Vector3d::UnitY()).norm(), 0., 1e-12);
}

TEST(LidarTest, WithoutErrorsTheDataSheetIsTrue) {
  const Lidar lidar = SmallLidar(kNoErrors);
  Random random(1);
  for (int beam = 0; beam < lidar.beams(); ++beam) {
    const Bearing nominal = lidar.Nominal(beam, 17 * beam);
    EXPECT_EQ(lidar.True(beam, nominal).elevation, nominal.elevation);
    EXPECT_EQ(lidar.True(beam, nominal).azimuth, nominal.azimuth);
    EXPECT_EQ(lidar.MeasureRange(beam, {20., 0.7, 0.1}, &random), 20.);
  }
}

// Each error alone, as big as its option says.
TEST(LidarTest, ErrorsHaveTheirSizes) {
  const std::string none = kNoErrors;
  constexpr double kDeg = M_PI / 180.;
  {
    const Lidar lidar = SmallLidar(none + "options.errors.axis_tilt_deg = 0.5");
    double largest = 0.;
    for (int column = 0; column < 300; ++column) {
      const Bearing nominal = lidar.Nominal(3, column);
      largest = std::max(largest, lidar.True(3, nominal).elevation - nominal.elevation);
    }
    EXPECT_NEAR(largest, 0.5 * kDeg, 1e-3 * kDeg);
  }
  {
    const Lidar lidar = SmallLidar(none + "options.errors.encoder_eccentricity_deg = 0.2");
    double largest = 0.;
    for (int column = 0; column < 300; ++column) {
      const Bearing nominal = lidar.Nominal(3, column);
      largest = std::max(largest, lidar.True(3, nominal).azimuth - nominal.azimuth);
    }
    EXPECT_NEAR(largest, 0.2 * kDeg, 1e-3 * kDeg);
  }
  {
    double squares = 0.;
    constexpr int kDevices = 300;
    const proto::SimulationOptions options =
        SmallOptions(none + "options.errors.beam_elevation_deg = 0.1");
    for (int seed = 0; seed < kDevices; ++seed) {
      const Lidar lidar(options.lidars(0), options.errors(), static_cast<uint64_t>(seed));
      const Bearing nominal = lidar.Nominal(5, 0);
      squares += std::pow((lidar.True(5, nominal).elevation - nominal.elevation) / kDeg, 2);
    }
    EXPECT_NEAR(std::sqrt(squares / kDevices), 0.1, 0.012);
  }
  Random random(1);
  EXPECT_NEAR(SmallLidar(none + "options.errors.range_scale = 0.0005")
                  .MeasureRange(0, {40., 0.3, 1.}, &random),
              40.02, 1e-9);
  EXPECT_NEAR(SmallLidar(none + "options.errors.intensity_range_m = 0.1")
                  .MeasureRange(0, {40., 0.8, 1.}, &random),
              39.95, 1e-9);
}

TEST(LidarTest, NoiseHasItsStandardDeviation) {
  const Lidar lidar = SmallLidar(std::string(kNoErrors) + "options.errors.range_noise_m = 0.02");
  Random random(4);
  double squares = 0.;
  for (int i = 0; i < 20000; ++i) {
    squares += std::pow(lidar.MeasureRange(0, {30., 0.3, 0.5}, &random) - 30., 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 20000), 0.02, 0.001);
}

TEST(LidarTest, WeakReturnsAreLost) {
  const Lidar lidar = SmallLidar(kNoErrors);  // half of the grey returns are lost at 60 m
  const auto share = [&](const Return& echo) {
    Random random(4);
    int seen = 0;
    for (int i = 0; i < 5000; ++i) seen += lidar.Detects(echo, &random);
    return seen / 5000.;
  };
  EXPECT_NEAR(share({60., 0.3, 1.}), 0.5, 0.03);
  EXPECT_GT(share({10., 0.3, 1.}), 0.99);
  EXPECT_LT(share({60., 0.05, 1.}), 0.05);
  EXPECT_LT(share({60., 0.3, 0.05}), share({60., 0.3, 0.5}));
}

TEST(LidarTest, UnknownLidarsAreListed) {
  proto::SimulationOptions options = SmallOptions();
  options.set_lidar("vlp17");
  const auto lidar = FindLidar(options);
  ASSERT_FALSE(lidar.ok());
  EXPECT_EQ(lidar.status().message(), "lidar \"vlp17\" is not declared; there are: small");
}

}  // namespace
}  // namespace semantic_kiss::simulation
