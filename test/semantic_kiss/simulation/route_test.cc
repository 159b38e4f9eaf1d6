// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "test/semantic_kiss/simulation/small_drive.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::simulation {
namespace {

Route RouteOf(const std::string& overrides) {
  const proto::SimulationOptions options = SmallOptions(overrides);
  auto route =
      MakeRoute(options.route(), options.scan_rate_hz(), static_cast<uint64_t>(options.seed()));
  CHECK(route.ok()) << route.status();
  return *std::move(route);
}

double Length(const Route& route) {
  double length_m = 0.;
  for (size_t i = 1; i < route.poses.size(); ++i) {
    length_m += (route.poses[i].position - route.poses[i - 1].position).norm();
  }
  return length_m;
}

TEST(RouteTest, HasTheLengthThatIsAskedFor) {
  for (const char* kind : {"city", "highway", "loop"}) {
    for (const int length_m : {50, 400, 3000}) {
      SCOPED_TRACE(kind);
      const Route route = RouteOf(std::string("options.route.kind = '") + kind +
                                  "' options.route.length_m = " + std::to_string(length_m));
      EXPECT_NEAR(Length(route), length_m, 0.02 * length_m + 4.);
      EXPECT_EQ(route.on_highway.size(), route.poses.size());
      EXPECT_EQ(route.on_highway.front(), std::string(kind) == "highway");
    }
  }
}

TEST(RouteTest, CarsDriveWhereTheyHead) {
  for (const char* kind : {"city", "highway", "loop"}) {
    SCOPED_TRACE(kind);
    const Route route =
        RouteOf(std::string("options.route.length_m = 1500. options.route.kind = '") + kind + "'");
    for (size_t i = 1; i < route.poses.size(); ++i) {
      const Eigen::Vector2d step = route.poses[i].position - route.poses[i - 1].position;
      EXPECT_GT(step.norm(), 0.1) << i;
      EXPECT_GT(step.normalized().dot(route.poses[i].Forward()), 0.98) << i;
      EXPECT_LT(std::abs(route.poses[i].yaw - route.poses[i - 1].yaw), 0.1) << i;
    }
  }
}

// Whether a later part of the route comes near an earlier one, heading alike or opposite.
bool Revisits(const Route& route, bool same_direction) {
  for (size_t i = 0; i < route.poses.size(); i += 5) {
    for (size_t j = i + 200; j < route.poses.size(); ++j) {
      const PlanarPose &a = route.poses[i], &b = route.poses[j];
      if ((a.position - b.position).norm() > 4.5) continue;
      const double alike = a.Forward().dot(b.Forward());
      if (same_direction ? alike > 0.95 : alike < -0.95) return true;
    }
  }
  return false;
}

TEST(RouteTest, CityRevisitsInBothDirectionsWhateverTheSeed) {
  for (int seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Route route =
        RouteOf("options.route.length_m = 800. options.seed = " + std::to_string(seed));
    EXPECT_TRUE(Revisits(route, true));
    EXPECT_TRUE(Revisits(route, false));
    EXPECT_GE(route.poses.size(), 800u);
  }
}

TEST(RouteTest, ReadsTheRealDrives) {
  const auto data = semantic_kiss_testing::RealDataDirectory();
  if (!data) GTEST_SKIP();
  for (const char* sequence : {"01", "07"}) {
    const Route route = RouteOf("options.route.kind = 'recorded' options.route.poses_file = '" +
                                *data + "/kitti_odometry/poses/" + sequence + ".txt'");
    EXPECT_EQ(route.poses.size(), 1101u);
    EXPECT_EQ(route.heights_m.size(), 1101u);
    const bool motorway = std::string(sequence) == "01";
    EXPECT_EQ(route.on_highway[550], motorway);
    EXPECT_NEAR(Length(route), motorway ? 2453. : 695., 5.);
  }
}

TEST(RouteTest, OfTheRealDrivesOnlyTheFaultyOneIsFlattened) {
  const auto data = semantic_kiss_testing::RealDataDirectory();
  if (!data) GTEST_SKIP();
  for (const char* sequence : {"00", "01", "02", "03", "04", "05", "06", "07", "08", "09", "10"}) {
    const std::string recorded = "options.route.kind = 'recorded' options.route.poses_file = '" +
                                 *data + "/kitti_odometry/poses/" + sequence + ".txt'";
    const auto heights_m = RouteOf(recorded).heights_m;
    const auto as_recorded_m = RouteOf(recorded + " options.route.max_slope = 1e9").heights_m;
    EXPECT_EQ(heights_m == as_recorded_m, std::string(sequence) != "08") << sequence;
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
