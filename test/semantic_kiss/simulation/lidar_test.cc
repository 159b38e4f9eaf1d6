// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/lidar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kDeg = M_PI / 180.;
constexpr double kRate_hz = 10.;

Lidar SmallLidar(const std::string& overrides, uint64_t seed = 1) {
  const proto::SimulationOptions options = SmallOptions(overrides);
  return Lidar(options.lidars(0), options.errors(), kRate_hz, seed);
}

TEST(LidarTest, BeamsSpreadFromTopToBottomAndTurnLeft) {
  const Lidar lidar = SmallLidar(kNoErrors);
  ASSERT_EQ(lidar.beams(), 16);
  EXPECT_NEAR(lidar.NominalElevation(0), 2. * kDeg, 1e-9);
  EXPECT_NEAR(lidar.NominalElevation(15), -24. * kDeg, 1e-9);
  EXPECT_NEAR(lidar.NominalAzimuth(0), -M_PI, 0.02);
  EXPECT_NEAR(lidar.NominalAzimuth(150), 0., 0.02);
  EXPECT_NEAR(lidar.NominalAzimuth(225), M_PI / 2., 0.02);
  std::vector<Shot> shots;
  lidar.Fire(225, lidar.ConditionAt(0), &shots);
  ASSERT_EQ(shots.size(), 16u);
  EXPECT_NEAR(shots[0].believed.y(), std::cos(2. * kDeg), 1e-3);
  EXPECT_NEAR(shots[15].believed.z(), std::sin(-24. * kDeg), 1e-12);
}

TEST(LidarTest, WithoutErrorsTheDataSheetIsTrue) {
  const Lidar lidar = SmallLidar(kNoErrors);
  Random random(1);
  std::vector<Shot> shots;
  for (int column = 0; column < lidar.columns(); column += 17) {
    lidar.Fire(column, lidar.ConditionAt(0), &shots);
    for (int beam = 0; beam < lidar.beams(); ++beam) {
      EXPECT_EQ(shots[beam].actual, shots[beam].believed);
      EXPECT_EQ(lidar.MeasureRange(beam, {20., 0.7, 0.1}, &random), 20.);
    }
  }
}

// Directions follow from the errors of the angles by exact trigonometry.
TEST(LidarTest, ShotsPointWhereTheErrorsSay) {
  const Lidar lidar = SmallLidar(
      "for _, name in ipairs({'beam_elevation_deg', 'beam_azimuth_deg', 'axis_tilt_deg',\n"
      "    'directional_elevation_deg', 'encoder_eccentricity_deg', 'bank_elevation_deg'}) do\n"
      "  options.errors[name] = 10. * options.errors[name]\n"
      "end");
  std::vector<Shot> shots;
  double largest = 0.;
  for (int column = 0; column < lidar.columns(); ++column) {
    lidar.Fire(column, lidar.ConditionAt(0), &shots);
    const double azimuth = lidar.NominalAzimuth(column);
    for (int beam = 0; beam < lidar.beams(); ++beam) {
      const Bearing error = lidar.Error(beam, lidar.ConditionAt(0), UnitAngle::Of(azimuth));
      const double e = lidar.NominalElevation(beam) + error.elevation;
      const double a = azimuth + error.azimuth;
      const Eigen::Vector3d expected(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a),
                                     std::sin(e));
      EXPECT_LT((shots[beam].actual - expected).norm(), 1e-8);
      largest = std::max(largest, std::abs(error.elevation));
    }
  }
  EXPECT_GT(largest, 1. * kDeg) << "no error to speak of";
}

TEST(LidarTest, TheRoofHidesTheLowestBeams) {
  const proto::SimulationOptions options = SmallOptions("options.lidars[1].hidden_by_car = true");
  const Lidar lidar(options.lidars(0), options.errors(), kRate_hz, 1);
  std::vector<Shot> shots;
  lidar.Fire(0, lidar.ConditionAt(0), &shots);  // backwards
  EXPECT_FALSE(shots[0].hidden);
  EXPECT_TRUE(shots[15].hidden);
  lidar.Fire(100, lidar.ConditionAt(0), &shots);  // to the right
  EXPECT_FALSE(shots[15].hidden);
}

// Each error alone, as big as its option says.
TEST(LidarTest, ErrorsHaveTheirSizes) {
  const std::string none = kNoErrors;
  {
    const Lidar lidar = SmallLidar(none + "options.errors.axis_tilt_deg = 0.5");
    double largest = 0.;
    for (int column = 0; column < 300; ++column) {
      const UnitAngle azimuth = UnitAngle::Of(lidar.NominalAzimuth(column));
      largest = std::max(largest, lidar.Error(3, lidar.ConditionAt(0), azimuth).elevation);
    }
    EXPECT_NEAR(largest, 0.5 * kDeg, 1e-3 * kDeg);
  }
  {
    const Lidar lidar = SmallLidar(none + "options.errors.encoder_eccentricity_deg = 0.2");
    double largest = 0.;
    for (int column = 0; column < 300; ++column) {
      const UnitAngle azimuth = UnitAngle::Of(lidar.NominalAzimuth(column));
      largest = std::max(largest, lidar.Error(3, lidar.ConditionAt(0), azimuth).azimuth);
    }
    EXPECT_NEAR(largest, 0.2 * kDeg, 1e-3 * kDeg);
  }
  {
    double squares = 0.;
    constexpr int kDevices = 300;
    const proto::SimulationOptions options =
        SmallOptions(none + "options.errors.beam_elevation_deg = 0.1");
    for (int seed = 0; seed < kDevices; ++seed) {
      const Lidar lidar(options.lidars(0), options.errors(), kRate_hz, static_cast<uint64_t>(seed));
      squares +=
          std::pow(lidar.Error(5, lidar.ConditionAt(0), UnitAngle::Of(0.3)).elevation / kDeg, 2);
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

// The stride has no common part with wander_s, so that all phases of the wander are met alike.
TEST(LidarTest, TheDeviceWandersSlowlyAndAsFarAsItsOptionSays) {
  const Lidar lidar =
      SmallLidar(std::string(kNoErrors) + "options.errors.elevation_wander_deg = 0.1");
  double squares = 0., largest_step = 0.;
  constexpr int kTimes = 4000, kStride = 307;
  for (int i = 0; i < kTimes; ++i) {
    const double now = lidar.ConditionAt(kStride * i).elevation / kDeg;
    squares += now * now;
    largest_step =
        std::max(largest_step, std::abs(lidar.ConditionAt(kStride * i + 1).elevation / kDeg - now));
  }
  EXPECT_NEAR(std::sqrt(squares / kTimes), 0.1, 0.03);
  EXPECT_GT(largest_step, 0.);
  EXPECT_LT(largest_step, 0.01);
  const Condition still = SmallLidar(kNoErrors).ConditionAt(12345);
  EXPECT_EQ(still.elevation, 0.);
  EXPECT_EQ(still.tilt.cosine, 0.);
  EXPECT_EQ(still.encoder.sine, 0.);
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
