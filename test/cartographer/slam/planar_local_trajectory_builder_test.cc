// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/planar_local_trajectory_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "test/testing/shipped_options.h"

namespace cartographer::slam {
namespace {

using transform::Rigid3d;

proto::PlanarBuilderOptions Options() {
  return semantic_kiss_testing::ShippedOptions<proto::PlanarBuilderOptions>(
      "planar_builder", "PLANAR_BUILDER", "PLANAR_BUILDER.submaps.scans_per_submap = 40");
}

Rigid3d PoseAt(double x, double y, double yaw_rad) {
  return Rigid3d({x, y, 0.},
                 Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())));
}

// House fronts step back and forth along the street.
double Depth(double x) { return 1.5 * std::round(std::sin(x / 3.)); }

// A street with such fronts and a road 1.7 m below the sensor.
sensor::LabeledScan SeeStreet(const Rigid3d& street_from_sensor, int index) {
  std::mt19937 random(index);
  std::uniform_real_distribution<float> uniform(0.f, 1.f);
  const Rigid3d sensor_from_street = street_from_sensor.inverse();
  sensor::LabeledScan scan;
  scan.index = index;
  scan.time = common::FromUnixSeconds(0.1 * index);
  const auto add = [&](double x, double y, double z) {
    if (uniform(random) < 0.3f) return;
    // A wall is rougher than a cell's border.
    const Eigen::Vector3d point(x + 0.1 * uniform(random), y + 0.1 * uniform(random), z);
    scan.points.positions.push_back((sensor_from_street * point).cast<float>());
    scan.points.labels.push_back(sensor::kUnlabeled);
    scan.points.certainties.push_back(1.f);
  };
  for (double x = -40.; x < 60.; x += 0.1) {
    const double depth = Depth(x), next_depth = Depth(x + 0.1);
    for (double z = -1.5; z < 2.; z += 0.5) {
      add(x, 8. + depth, z);
      add(x, -9. - depth, z);
      const double near = std::min(depth, next_depth), far = std::max(depth, next_depth);
      for (double side = near; side < far; side += 0.1) {
        add(x, 8. + side, z);
        add(x, -9. - side, z);
      }
    }
    for (double y = -7.; y < 7.; y += 1.) add(x, y, -1.7);
  }
  return scan;
}

TEST(PlanarLocalTrajectoryBuilderTest, FollowsADrive) {
  PlanarLocalTrajectoryBuilder builder(Options(), sensor::LabelSet());
  for (int i = 0; i < 40; ++i) {
    const Rigid3d truth = PoseAt(0.7 * i, 0.5 * std::sin(0.1 * i), 0.07 * std::cos(0.1 * i) - 0.07);
    const LocalResult result = builder.AddScan(SeeStreet(truth, i));
    EXPECT_EQ(result.outcome, i == 0 ? "first" : "matched");
    EXPECT_EQ(result.time, common::FromUnixSeconds(0.1 * i));
    EXPECT_LT((result.local_from_sensor.translation() - truth.translation()).norm(), 0.1) << i;
    EXPECT_LT(transform::RotationAngle(result.local_from_sensor.inverse() * truth), 0.01) << i;
    EXPECT_EQ(result.local_from_sensor.translation().z(), 0.);
    ASSERT_TRUE(result.insertion.has_value());
    EXPECT_GE(result.insertion->cloud->size(), 1000);
    // No road in it.
    for (const Eigen::Vector3f& position : result.insertion->cloud->positions) {
      EXPECT_GE(position.z(), -1.f);
    }
    EXPECT_EQ(result.insertion->submaps.size(), i < 20 ? 1 : 2);
    if (i == 39) {
      EXPECT_TRUE(result.insertion->submaps.at(0)->finished);
      EXPECT_FALSE(result.insertion->submaps.at(1)->finished);
      builder.Finish();
      EXPECT_TRUE(result.insertion->submaps.at(1)->finished);
    }
  }
}

TEST(PlanarLocalTrajectoryBuilderTest, FollowsATurnThatBeginsAtOnce) {
  PlanarLocalTrajectoryBuilder builder(Options(), sensor::LabelSet());
  for (int i = 0; i < 16; ++i) {
    const Rigid3d truth = PoseAt(0.7 * i, 0., std::max(0, i - 8) * 3.5 * M_PI / 180.);
    const LocalResult result = builder.AddScan(SeeStreet(truth, i));
    EXPECT_LT((result.local_from_sensor.translation() - truth.translation()).norm(), 0.1) << i;
    EXPECT_LT(transform::RotationAngle(result.local_from_sensor.inverse() * truth), 0.01) << i;
  }
}

TEST(PlanarLocalTrajectoryBuilderTest, AScanThatShowsNothingIsPlacedAsExpectedAndNotMapped) {
  PlanarLocalTrajectoryBuilder builder(Options(), sensor::LabelSet());
  for (int i = 0; i < 12; ++i) {
    sensor::LabeledScan scan = SeeStreet(PoseAt(0.7 * i, 0., 0.), i);
    if (i == 6) scan.points.Clear();
    const LocalResult result = builder.AddScan(scan);
    EXPECT_EQ(result.outcome, i == 0 ? "first" : i == 6 ? "too_few_points" : "matched");
    EXPECT_EQ(result.insertion.has_value(), i != 6);
    EXPECT_NEAR(result.local_from_sensor.translation().x(), 0.7 * i, 0.1);
  }
}

TEST(PlanarLocalTrajectoryBuilderTest, BeginsWithTheFirstScanThatShowsSomething) {
  PlanarLocalTrajectoryBuilder builder(Options(), sensor::LabelSet());
  for (int i = -3; i < 12; ++i) {
    sensor::LabeledScan scan = SeeStreet(PoseAt(0.7 * i, 0., 0.), i);
    if (i < 0) scan.points.Clear();
    const LocalResult result = builder.AddScan(scan);
    EXPECT_EQ(result.outcome, i <= 0 ? "first" : "matched") << i;
    EXPECT_TRUE(result.insertion.has_value()) << i;
    EXPECT_NEAR(result.local_from_sensor.translation().x(), std::max(0, i) * 0.7, 0.1) << i;
  }
}

TEST(PlanarLocalTrajectoryBuilderTest, AStandingSensorMakesNoNodes) {
  PlanarLocalTrajectoryBuilder builder(Options(), sensor::LabelSet());
  for (int i = 0; i < 5; ++i) {
    const LocalResult result = builder.AddScan(SeeStreet(Rigid3d(), i));
    EXPECT_EQ(result.insertion.has_value(), i == 0);
    EXPECT_LT(result.local_from_sensor.translation().norm(), 0.05);
  }
}

TEST(PlanarLocalTrajectoryBuilderTest, OptionsOfAnotherBuilderAreAnError) {
  LocalTrajectoryBuilderRegistry registry;
  RegisterPlanarLocalTrajectoryBuilder(&registry);
  sensor::proto::LabelSet options;  // has a name, but nothing called "planar"
  options.set_name("planar");
  EXPECT_THAT(std::string(registry.Create(options, sensor::LabelSet()).status().message()),
              testing::HasSubstr("planar"));
}

}  // namespace
}  // namespace cartographer::slam
