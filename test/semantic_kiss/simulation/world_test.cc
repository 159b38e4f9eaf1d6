// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

// Lowest height above the ground that a primitive has; crowns and arms may hang over the street.
double Underside(const World& world, const Primitive& primitive) {
  return primitive.Bottom() - world.ground().Height(primitive.centre.head<2>());
}

void ExpectFreeWay(const Simulation& drive) {
  constexpr double kHalfCar_m = 0.95;
  constexpr double kOverhead_m = 2.2;
  for (size_t i = 0; i < drive.route().poses.size(); i += 3) {
    const Eigen::Vector2d car = drive.route().poses[i].position;
    for (const Primitive& primitive : drive.world().primitives()) {
      const Eigen::Vector2d offset = car - primitive.centre.head<2>();
      if (offset.norm() > primitive.PlanarRadius() + kHalfCar_m) continue;
      const Eigen::Vector3d local = primitive.ToLocal({offset.x(), offset.y(), 0.});
      const Eigen::Array2d beyond =
          (local.head<2>().array().abs() - primitive.half.head<2>().array()).max(0.);
      if (beyond.matrix().norm() > kHalfCar_m) continue;
      EXPECT_GT(Underside(drive.world(), primitive), kOverhead_m)
          << "scan " << i << ", label " << primitive.material.label;
    }
  }
}

TEST(WorldTest, NothingStaticStandsOnTheDrivenWay) {
  for (const char* seed : {"1", "2", "3"}) {
    SCOPED_TRACE(seed);
    const std::string overrides = std::string("options.seed = ") + seed + "\n";
    ExpectFreeWay(*SmallDrive(overrides + "options.route.length_m = 300."));
    ExpectFreeWay(
        *SmallDrive(overrides + "options.route.kind = 'loop' options.route.length_m = 400."));
    ExpectFreeWay(
        *SmallDrive(overrides + "options.route.kind = 'highway' options.route.length_m = 600."));
  }
}

TEST(WorldTest, TheSeedMakesTheWorld) {
  const auto a = SmallDrive(), same = SmallDrive(), other = SmallDrive("options.seed = 2");
  ASSERT_EQ(a->world().primitives().size(), same->world().primitives().size());
  for (size_t i = 0; i < a->world().primitives().size(); ++i) {
    EXPECT_EQ(a->world().primitives()[i].centre, same->world().primitives()[i].centre);
  }
  EXPECT_NE(a->world().primitives().size(), other->world().primitives().size());
}

TEST(WorldTest, EpochsDifferOnlyInWhatIsMovable) {
  const auto first = SmallDrive("options.route.length_m = 300.");
  const auto next = SmallDrive("options.route.length_m = 300. options.epoch = 1");
  const auto statics = [](const World& world) {
    std::vector<Primitive> kept;
    for (const Primitive& primitive : world.primitives()) {
      if (!IsMovable(primitive.material.label)) kept.push_back(primitive);
    }
    return kept;
  };
  const auto a = statics(first->world()), b = statics(next->world());
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].object, b[i].object);
    EXPECT_EQ(a[i].centre, b[i].centre);
    EXPECT_EQ(a[i].half, b[i].half);
    EXPECT_EQ(a[i].material.label, b[i].material.label);
    EXPECT_EQ(a[i].material.remission, b[i].material.remission);
  }
  EXPECT_LT(a.size(), first->world().primitives().size()) << "nothing is parked";
  for (double x = -50.; x < 50.; x += 1.3) {
    const Eigen::Vector2d point(x, 0.7 * x);
    EXPECT_EQ(first->world().ground().Height(point), next->world().ground().Height(point));
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
