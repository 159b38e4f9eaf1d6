// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "semantic_kiss/simulation/hills.h"
#include "semantic_kiss/simulation/random.h"
#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

TEST(HillsTest, FollowARecordingsHeights) {
  Route route;
  for (int i = 0; i < 300; ++i) {
    route.poses.push_back({{1. * i, 0.}, 0.});
    route.heights_m.push_back(4. * std::sin(i / 60.) + 1.73);
  }
  const Eigen::AlignedBox2d bounds(Eigen::Vector2d(-80., -80.), Eigen::Vector2d(380., 80.));
  const Hills hills(route, bounds, SmallOptions().world(), 1.73, 1);
  for (int i = 20; i < 280; i += 7) {
    EXPECT_NEAR(hills.Height({1. * i, 0.}), 4. * std::sin(i / 60.), 0.35) << i;
    // Level across the street.
    EXPECT_NEAR(hills.Height({1. * i, 5.}), hills.Height({1. * i, -5.}), 0.05) << i;
  }
}

TEST(HillsTest, SlopesAreContinuous) {
  const auto drive = SmallDrive("options.world.hill_height_m = 10.");
  const Hills& hills = drive->world().hills();
  constexpr double kStep = 1e-3;
  double last_slope = 0.;
  for (double x = -30.; x < 30.; x += 0.05) {
    const double slope =
        (hills.Height({x + kStep, 3.}) - hills.Height({x - kStep, 3.})) / (2. * kStep);
    if (x > -30.) {
      EXPECT_NEAR(slope, last_slope, 0.03) << x;
    }
    last_slope = slope;
  }
}

TEST(HillsTest, GoOnBeyondTheirBounds) {
  const auto drive = SmallDrive();
  EXPECT_TRUE(std::isfinite(drive->world().hills().Height({1e5, -1e5})));
}

// The oracle walks along the ray in steps of a centimetre.
TEST(GroundTest, IntersectionAgreesWithWalking) {
  const auto drive = SmallDrive("options.world.hill_height_m = 6.");
  const Ground& ground = drive->world().ground();
  Random random(3, Purpose::kRay);
  int hits = 0, slips = 0;
  for (int i = 0; i < 300; ++i) {
    const PlanarPose& pose = drive->route().poses[random.Index(drive->num_scans())];
    Ray ray;
    ray.origin << pose.position, drive->world().hills().Height(pose.position) + 1.73;
    const double azimuth = random.Uniform(0., 2. * M_PI), elevation = random.Uniform(-0.4, 0.03);
    ray.direction << std::cos(elevation) * std::cos(azimuth),
        std::cos(elevation) * std::sin(azimuth), std::sin(elevation);
    double walked = 0.;
    const auto above = [&](double t) {
      const Eigen::Vector3d p = ray.origin + t * ray.direction;
      return p.z() > ground.Height(p.head<2>());
    };
    while (walked < 40. && above(walked)) walked += 0.01;
    const auto hit = ground.Intersect(ray, 0., 40.);
    ASSERT_EQ(hit.has_value(), walked < 40.) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_FALSE(above(*hit + 0.01)) << i;
    slips += std::abs(*hit - walked) > 0.03;
  }
  EXPECT_GT(hits, 150);
  // A ray may slip over a crest lower than a step of the search.
  EXPECT_LE(slips, hits / 50);
}

TEST(GroundTest, SearchesMayBeginNearTheGround) {
  const auto drive = SmallDrive();
  const Ground& ground = drive->world().ground();
  const Eigen::Vector2d start = drive->route().poses[0].position;
  const Ray ray{{start.x(), start.y(), ground.Height(start) + 1.7},
                Eigen::Vector3d(0.95, 0., -0.2).normalized()};
  const auto hit = ground.Intersect(ray, 0., 40.);
  ASSERT_TRUE(hit);
  for (const double from : {0.5 * *hit, *hit - 0.01, *hit + 0.5}) {
    const auto again = ground.Intersect(ray, from, 40.);
    ASSERT_TRUE(again) << from;
    EXPECT_NEAR(*again, *hit, 0.03) << from;
  }
  EXPECT_FALSE(ground.Intersect(ray, 0., *hit - 0.1));
}

TEST(GroundTest, StreetsHaveKerbsSidewalksAndMarkings) {
  const auto drive = SmallDrive("options.route.length_m = 200.");
  const Ground& ground = drive->world().ground();
  std::set<uint16_t> labels;
  for (const PlanarPose& pose : drive->route().poses) {
    const uint16_t driven = ground.MaterialAt(pose.position).label;
    EXPECT_TRUE(driven == label::kRoad || driven == label::kLaneMarking) << driven;
    for (double left = -12.; left < 12.; left += 0.04) {
      labels.insert(ground.MaterialAt(pose.position + left * pose.Left()).label);
    }
  }
  EXPECT_EQ(labels.count(label::kSidewalk), 1u);
  EXPECT_EQ(labels.count(label::kTerrain), 1u);
  EXPECT_EQ(labels.count(label::kLaneMarking), 1u);
}

TEST(GroundTest, NormalsAreUpright) {
  const auto drive = SmallDrive();
  for (const PlanarPose& pose : drive->route().poses) {
    const Eigen::Vector3d normal = drive->world().ground().Normal(pose.position);
    EXPECT_NEAR(normal.norm(), 1., 1e-9);
    EXPECT_GT(normal.z(), 0.95);
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
