// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/ray_fan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "semantic_kiss/simulation/facade.h"
#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/things.h"
#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kReach_m = 60.;

// What the ray meets, by looking at everything there is.
std::optional<Hit> MeetByLookingAtAll(const World& world, const Ray& ray, uint64_t key) {
  const std::optional<double> ground = world.ground().Intersect(ray, 0., kReach_m);
  double best = ground.value_or(kReach_m);
  std::optional<Hit> hit;
  if (ground) hit.emplace().range_m = best;
  for (size_t i = 0; i < world.primitives().size(); ++i) {
    const Primitive& primitive = world.primitives()[i];
    const auto stretch = Intersect(primitive, {primitive.ToLocal(ray.origin - primitive.centre),
                                               primitive.ToLocal(ray.direction)});
    if (!stretch) continue;
    const auto t = StopIn(primitive, *stretch, key);
    if (!t || *t >= best) continue;
    best = *t;
    hit = Hit{best,
              primitive.FromLocal(stretch->normal),
              primitive.material,
              primitive.object,
              primitive.texture,
              static_cast<int>(i)};
  }
  if (hit && hit->primitive >= 0 && hit->texture == Texture::kFacade) {
    ShapeFacade(world.primitives()[hit->primitive], ray, world.wall_relief_m(), world.seed(),
                &*hit);
  }
  return hit;
}

// Directions of a tilted device's beams that all err a little in azimuth.
std::vector<Eigen::Vector3d> Firing(double azimuth, double error, Random* random) {
  const Eigen::Matrix3d tilt = (Eigen::AngleAxisd(0.06, Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(-0.03, Eigen::Vector3d::UnitY()))
                                   .toRotationMatrix();
  std::vector<Eigen::Vector3d> directions;
  for (double elevation = 0.3; elevation > -0.45; elevation -= 0.03) {
    const double a = azimuth + random->Uniform(-error, error);
    directions.push_back(tilt * Eigen::Vector3d(std::cos(elevation) * std::cos(a),
                                                std::cos(elevation) * std::sin(a),
                                                std::sin(elevation)));
  }
  return directions;
}

struct Comparison {
  int rays = 0, hits = 0, on_primitives = 0, different = 0;
};

// `error`: by how much azimuths differ within a firing.
Comparison Compare(const Simulation& drive, double error) {
  const World& world = drive.world();
  Random random(8, Purpose::kRay);
  RayFan fan(world, kReach_m);
  Comparison comparison;
  for (int trial = 0; trial < 60; ++trial) {
    const Eigen::Vector3d origin =
        drive.world_from_lidar()[random.Index(drive.num_scans())].translation();
    const auto directions = Firing(random.Uniform(0., 2. * M_PI), error, &random);
    fan.Open(origin, directions);
    for (size_t i = 0; i < directions.size(); ++i) {
      const uint64_t key = random.Next();
      const auto hit = fan.Cast(i, key);
      const auto expected = MeetByLookingAtAll(world, {origin, directions[i]}, key);
      ++comparison.rays;
      comparison.hits += expected.has_value();
      comparison.on_primitives += expected && expected->primitive >= 0;
      const bool same = hit.has_value() == expected.has_value() &&
                        (!hit || (hit->primitive == expected->primitive &&
                                  std::abs(hit->range_m - expected->range_m) <
                                      (hit->primitive < 0 ? 0.05 : 1e-9)));
      comparison.different += !same;
    }
  }
  return comparison;
}

TEST(RayFanTest, MeetsWhatLookingAtAllMeets) {
  for (const char* route : {"city", "highway"}) {
    SCOPED_TRACE(route);
    const auto drive = SmallDrive(std::string("options.route.kind = '") + route + "'");
    const Comparison comparison = Compare(*drive, 0.004);
    EXPECT_GT(comparison.on_primitives, 200);
    EXPECT_GT(comparison.hits, comparison.on_primitives + 300);
    // Where a ray grazes a kerb the two searches for the ground may find its one or other side.
    EXPECT_LE(comparison.different, comparison.rays / 200);
  }
}

TEST(RayFanTest, RaysMaySpreadAllRound) {
  const auto drive = SmallDrive();
  const Comparison comparison = Compare(*drive, 3.1);
  EXPECT_GT(comparison.on_primitives, 200);
  EXPECT_LE(comparison.different, comparison.rays / 200);
}

TEST(RayFanTest, UprightRays) {
  const auto drive = SmallDrive();
  const Eigen::Vector3d origin = drive->world_from_lidar()[10].translation();
  RayFan fan(drive->world(), kReach_m);
  fan.Open(origin, {-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()});
  const auto below = fan.Cast(0, 1);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->range_m, origin.z() - drive->world().ground().Height(origin.head<2>()), 1e-3);
  EXPECT_EQ(below->object, kGroundObject);
}

TEST(RayFanTest, WhatMovesIsSeenFromWhereItSees) {
  const auto drive = SmallDrive(kNothingMovable);
  const auto& pose = drive->world_from_lidar()[10];
  const Eigen::Vector3d origin = pose.translation();
  const Eigen::Vector3d ahead = pose.rotation() * Eigen::Vector3d::UnitX();
  Primitive wall;
  wall.centre = origin + 6. * ahead;
  wall.half << 0.1, 3., 3.;
  wall.SetYaw(std::atan2(ahead.y(), ahead.x()));
  wall.object = 77;
  RayFan fan(drive->world(), kReach_m);
  fan.Open(origin, {ahead});
  fan.AddMoving(wall, origin);
  const auto standing = fan.Cast(0, 1);
  ASSERT_TRUE(standing);
  EXPECT_NEAR(standing->range_m, 5.9, 0.02);
  EXPECT_EQ(standing->object, 77u);
  EXPECT_TRUE(standing->moving);
  fan.Open(origin, {ahead});
  fan.AddMoving(wall, origin - 2. * ahead);
  EXPECT_NEAR(fan.Cast(0, 1)->range_m, 7.9, 0.02);
  // A new fan has forgotten it.
  fan.Open(origin, {ahead});
  const auto without = fan.Cast(0, 1);
  EXPECT_TRUE(!without || !without->moving);
}

}  // namespace
}  // namespace semantic_kiss::simulation
