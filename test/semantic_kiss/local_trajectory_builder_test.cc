// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/local_trajectory_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "test/testing/odometry_on_sequence.h"

namespace semantic_kiss {
namespace {

using cartographer::slam::LocalResult;
using cartographer::transform::Rigid3d;

constexpr double kStep_m = 0.8;

// A street between house fronts that step back and forth, seen after `index` steps along it.
cartographer::sensor::LabeledScan SeeStreet(int index, const Eigen::Vector3d& lifted_by) {
  cartographer::sensor::LabeledScan scan;
  scan.index = index;
  scan.time = cartographer::common::FromUnixSeconds(0.1 * index);
  const Eigen::Vector3d sensor(kStep_m * index, 0., 0.);
  std::mt19937 random(index);
  std::uniform_real_distribution<double> uniform(0., 0.4);
  const auto add = [&](double x, double y, double z) {
    const Eigen::Vector3d point = Eigen::Vector3d(x + uniform(random), y, z) - sensor + lifted_by;
    scan.points.positions.push_back(point.cast<float>());
    scan.points.labels.push_back(cartographer::sensor::kUnlabeled);
    scan.points.certainties.push_back(1.f);
  };
  for (double x = -40.; x < 60.; x += 0.4) {
    const double depth = 1.5 * std::round(std::sin(x / 3.));
    for (double z = -1.5; z < 4.; z += 0.5) {
      add(x, 8. + depth, z);
      add(x, -9. - depth, z);
    }
    for (double y = -7.; y < 7.; y += 0.7) add(x, y, -1.7);
  }
  return scan;
}

// The results of a drive of which scans from `first_lifted` on, so many, show a world far above.
std::vector<LocalResult> DriveWithLiftedScans(int num_scans, int first_lifted, int num_lifted,
                                              double lifted_m) {
  LocalTrajectoryBuilder builder(semantic_kiss_testing::ShippedOptions(),
                                 semantic_kiss_testing::ShippedLabels());
  std::vector<LocalResult> results;
  for (int i = 0; i < num_scans; ++i) {
    const bool lifted = i >= first_lifted && i < first_lifted + num_lifted;
    results.push_back(builder.AddScan(SeeStreet(i, {0., 0., lifted ? lifted_m : 0.})));
  }
  builder.Finish();
  return results;
}

TEST(LocalTrajectoryBuilderTest, AScanThatCannotBePlacedBecomesNoNode) {
  const std::vector<LocalResult> results = DriveWithLiftedScans(12, 6, 2, 60.);
  for (int i = 0; i < 12; ++i) {
    const bool lifted = i == 6 || i == 7;
    EXPECT_EQ(results[i].outcome == "no_correspondences", lifted) << i << results[i].outcome;
    EXPECT_EQ(results[i].insertion.has_value(), !lifted) << i;
    EXPECT_NEAR(results[i].local_from_sensor.translation().x(), kStep_m * i, 0.3) << i;
  }
  // The lifted scans are in no submap.
  for (const Eigen::Vector3f& point : results[11].insertion->submaps.at(0)->cloud.positions) {
    EXPECT_LT(point.z(), 30.f);
  }
}

TEST(LocalTrajectoryBuilderTest, SubmapsBeginAnewWithTheOdometry) {
  const std::vector<LocalResult> results = DriveWithLiftedScans(40, 6, 34, 60.);
  int restarted = 0;
  while (restarted < 40 && results[restarted].outcome != "restarted") ++restarted;
  ASSERT_LT(restarted, 30);
  EXPECT_EQ(results[5].insertion->submaps.count(0), 1);
  EXPECT_TRUE(results[5].insertion->submaps.at(0)->finished);
  ASSERT_TRUE(results[restarted].insertion.has_value());
  EXPECT_EQ(results[restarted].insertion->submaps.begin()->first, 1);
  EXPECT_EQ(results[restarted + 1].outcome, "converged");
  EXPECT_EQ(results[restarted + 1].insertion->submaps.begin()->first, 1);
}

}  // namespace
}  // namespace semantic_kiss
