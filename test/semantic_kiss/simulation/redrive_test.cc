// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/redrive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

// A bend of 50 m radius to the left, at 1 m a scan.
Route Bend() {
  Route route;
  for (int i = 0; i <= 60; ++i) {
    const double yaw = i / 50.;
    route.poses.push_back({{50. * std::sin(yaw), 50. * (1. - std::cos(yaw))}, yaw});
    route.on_highway.push_back(i >= 30);
    route.heights_m.push_back(0.1 * i);
  }
  return route;
}

TEST(RedriveTest, NothingChangedIsTheRouteItself) {
  const Route route = Bend();
  const Route driven = Redrive(route, 0., 1.);
  ASSERT_EQ(driven.poses.size(), route.poses.size());
  for (size_t i = 0; i < route.poses.size(); ++i) {
    EXPECT_EQ(driven.poses[i].position, route.poses[i].position);
    EXPECT_EQ(driven.poses[i].yaw, route.poses[i].yaw);
  }
  EXPECT_EQ(driven.on_highway, route.on_highway);
  EXPECT_EQ(driven.heights_m, route.heights_m);
}

TEST(RedriveTest, TheOffsetIsToTheLeftAndTheSpeedIsAsAsked) {
  for (const double factor : {0.7, 1., 1.6}) {
    const Route driven = Redrive(Bend(), 0.8, factor);
    EXPECT_EQ(driven.poses.size(), static_cast<size_t>(60. / factor) + 1);
    ASSERT_EQ(driven.on_highway.size(), driven.poses.size());
    for (size_t i = 0; i < driven.poses.size(); ++i) {
      // To the left of a left bend is nearer to its centre.
      EXPECT_NEAR((driven.poses[i].position - Eigen::Vector2d(0., 50.)).norm(), 49.2, 0.01);
      EXPECT_NEAR(driven.poses[i].yaw, i * factor / 50., 1e-9);
      EXPECT_NEAR(driven.heights_m[i], 0.1 * factor * i, 1e-9);
    }
  }
}

// What is written shares the town's frame, whoever drives.
TEST(RedriveTest, PosesOfAnotherDriverLieBesideThoseOfTheFirst) {
  const auto first = SmallDrive("");
  const auto other = SmallDrive(
      "options.route.lane_offset_m = -0.6 options.route.speed_factor = 2. options.epoch = 1");
  ASSERT_LT(other->num_scans(), first->num_scans());
  EXPECT_EQ(other->world_from_start().translation(), first->world_from_start().translation());
  for (int i = 0; i < other->num_scans(); ++i) {
    const auto offset = first->world_from_lidar()[2 * i].inverse() * other->world_from_lidar()[i];
    EXPECT_NEAR(offset.translation().y(), -0.6, 0.05);
    EXPECT_NEAR(offset.translation().x(), 0., 0.05);
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
