// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/traffic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

TEST(TrafficTest, MovesAsItsVelocitySays) {
  const auto drive = SmallDrive("options.route.length_m = 300. options.world.traffic_density = 3.");
  const Traffic traffic(drive->route(), drive->world().streets(), 3., 10., 1, 0);
  int compared = 0;
  for (int scan = 5; scan + 1 < drive->num_scans(); scan += 7) {
    std::map<uint32_t, MovingThing> now;
    for (const MovingThing& thing : traffic.At(scan, 60., drive->world().ground())) {
      now.insert({thing.pieces[0].object, thing});
    }
    for (const MovingThing& next : traffic.At(scan + 0.5, 60., drive->world().ground())) {
      const auto before = now.find(next.pieces[0].object);
      if (before == now.end()) continue;
      const Eigen::Vector2d step = next.centre - before->second.centre;
      // Bends stretch or shrink the way of what is beside the route's line.
      const Eigen::Vector2d expected = 0.05 * before->second.velocity.head<2>();
      EXPECT_LT((step - expected).norm(), 0.15 + 0.35 * expected.norm());
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(TrafficTest, NeverDrivesIntoTheCar) {
  for (const char* kind : {"city", "highway", "loop"}) {
    SCOPED_TRACE(kind);
    const auto drive =
        SmallDrive(std::string("options.route.length_m = 700. options.world.traffic_density = 3. "
                               "options.route.kind = '") +
                   kind + "'");
    const Traffic traffic(drive->route(), drive->world().streets(), 3., 10., 1, 0);
    for (int scan = 0; scan < drive->num_scans(); ++scan) {
      for (const MovingThing& thing : traffic.At(scan, 60., drive->world().ground())) {
        const PlanarPose& car = drive->route().poses[scan];
        const Eigen::Vector2d offset = thing.centre - car.position;
        EXPECT_FALSE(std::abs(offset.dot(car.Forward())) < 2.2 &&
                     std::abs(offset.dot(car.Left())) < 1.5)
            << "scan " << scan << ", label " << thing.pieces[0].material.label;
      }
    }
  }
}

TEST(TrafficTest, CarriesMovingLabelsAndDependsOnTheDay) {
  const auto drive = SmallDrive("options.route.length_m = 800.");
  const auto labels_of = [&](const Traffic& traffic) {
    std::vector<std::pair<int, uint16_t>> labels;
    for (int scan = 0; scan < drive->num_scans(); scan += 10) {
      for (const MovingThing& thing : traffic.At(scan, 60., drive->world().ground())) {
        labels.emplace_back(scan, thing.pieces[0].material.label);
      }
    }
    return labels;
  };
  const StreetMap& streets = drive->world().streets();
  const auto today = labels_of(Traffic(drive->route(), streets, 1., 10., 1, 0));
  EXPECT_EQ(today, labels_of(Traffic(drive->route(), streets, 1., 10., 1, 0)));
  EXPECT_NE(today, labels_of(Traffic(drive->route(), streets, 1., 10., 1, 1)));
  EXPECT_TRUE(labels_of(Traffic(drive->route(), streets, 0., 10., 1, 0)).empty());
  std::set<uint16_t> kinds;
  for (const auto& [scan, label] : today) kinds.insert(label);
  for (const uint16_t label : {label::kMovingCar, label::kMovingBicyclist, label::kMovingPerson}) {
    EXPECT_EQ(kinds.count(label), 1u) << label;
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
