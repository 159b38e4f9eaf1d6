// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/street_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace semantic_kiss::simulation {
namespace {

// Along the x axis, a metre a scan.
Route StraightRoute(int scans) {
  Route route;
  for (int i = 0; i < scans; ++i) route.poses.push_back({{1. * i, 0.}, 0.});
  route.on_highway.assign(scans, false);
  return route;
}

TEST(StreetMapTest, DistancesAreThoseFromTheLines) {
  const StreetMap streets(StraightRoute(100), 60., 1);
  for (const double y : {-12., -5., 0., 2., 7., 20.}) {
    const Eigen::Vector2d point(50.3, y);
    const StreetMap::Place place = streets.Find(point);
    ASSERT_GE(place.nearest, 0);
    const double half_width_m = streets.centres()[place.nearest].section.half_width_m;
    // The car keeps to the right: the street's middle is at y = 1.8.
    EXPECT_NEAR(place.across_m, std::abs(y - 1.8), 0.01);
    // On the middle itself, where the distance has a kink, the lattice rounds it off.
    EXPECT_NEAR(place.outside_m, std::abs(y - 1.8) - half_width_m, 0.2);
    EXPECT_EQ(place.side, y > 1.8 ? 0 : 1);
    EXPECT_NEAR(streets.Clearance(point), std::abs(y) > 8. ? StreetMap::kReach_m : std::abs(y),
                0.26);
  }
  EXPECT_EQ(streets.Find({50., 80.}).nearest, -1);
  EXPECT_EQ(streets.Outside({50., 80.}), StreetMap::kReach_m);
}

TEST(StreetMapTest, ARevisitMakesNoSecondStreet) {
  Route there = StraightRoute(200);
  const StreetMap once(there, 60., 1);
  Route back = there;
  for (int i = 0; i < 20; ++i) {  // turns round in a half circle, to the left
    const double yaw = M_PI * (i + 1) / 20.;
    back.poses.push_back({{199. + 1.8 * std::sin(yaw), 1.8 - 1.8 * std::cos(yaw)}, yaw});
  }
  for (int i = 199; i >= 0; --i) back.poses.push_back({{1. * i, 3.6}, M_PI});
  back.on_highway.assign(back.poses.size(), false);
  const StreetMap twice(back, 60., 1);
  EXPECT_LT(twice.centres().size(), once.centres().size() + 30);
  for (const double y : {-6., 0., 4., 9.}) {
    EXPECT_NEAR(twice.Outside({100., y}), once.Outside({100., y}), 0.05);
  }
}

TEST(StreetMapTest, CoversAreKept) {
  StreetMap streets(StraightRoute(50), 60., 1);
  streets.SetCover({20., 15.}, Cover::kLot);
  EXPECT_EQ(streets.Find({20., 15.}).cover, Cover::kLot);
  EXPECT_EQ(streets.Find({22., 15.}).cover, Cover::kByStreet);
  streets.SetCover({1e6, 0.}, Cover::kLot);  // outside: ignored
}

TEST(StreetMapTest, AStandingCarMakesOneStreet) {
  Route route = StraightRoute(30);
  for (int i = 0; i < 50; ++i) route.poses.push_back(route.poses.back());
  route.on_highway.assign(route.poses.size(), false);
  const StreetMap streets(route, 40., 1);
  EXPECT_EQ(streets.streets().size(), 1u);
  EXPECT_NEAR(static_cast<double>(streets.centres().size()), 30., 2.);
}

}  // namespace
}  // namespace semantic_kiss::simulation
