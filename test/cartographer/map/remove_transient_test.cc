// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_transient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "glog/logging.h"
#include "test/cartographer/map/visited_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using ::testing::ElementsAre;

void Remove(const proto::TransientOptions& options, Map* map,
            const proto::FilterOptions& where = {}) {
  const auto scope = FilterScope::Create(where, *map);
  CHECK(scope.ok()) << scope.status();
  RemoveTransient(*scope, options, map);
}

TEST(RemoveTransientTest, AnEmptyMapStaysEmpty) {
  Map map;
  Remove(SharpTransientOptions(), &map);
  EXPECT_TRUE(map.submaps.empty());
}

TEST(RemoveTransientTest, CarsGoAndUncoverTheRoad) {
  Map map = VisitedMap({{0., {"RccB", "RccB"}}, {100., {"RRcB", "RRRB"}}});
  Remove(SharpTransientOptions(), &map);
  EXPECT_THAT(HitsOf("car", map, {0, 0}, 4, 2), ElementsAre("..#.", "...."));
  EXPECT_THAT(HitsOf("car", map, {0, 1}, 4, 2), ElementsAre("..#.", "...."));
  EXPECT_THAT(HitsOf("road", map, {0, 0}, 4, 2), ElementsAre("###.", "###."));
  EXPECT_THAT(HitsOf("building", map, {0, 0}, 4, 2), ElementsAre("...#", "...#"));
}

TEST(RemoveTransientTest, PointsGoWithTheirCells) {
  Map map = VisitedMap({{0., {"CC"}}, {100., {"R."}}});
  auto submap = std::make_shared<submap::Submap>(*map.submaps.at({0, 0}).submap);
  auto cloud = std::make_shared<sensor::LabeledPointCloud>();
  for (const float x : {0.5f, 1.5f}) {
    cloud->positions.emplace_back(x, 0.5f, 1.f);
    cloud->labels.push_back(SketchLabel("car"));
    cloud->certainties.push_back(1.f);
  }
  submap->cloud = *cloud;
  map.submaps[{0, 0}].submap = submap;
  map.nodes[{0, 0}].cloud = cloud;
  Remove(SharpTransientOptions(), &map);
  for (const auto* left :
       {&map.submaps.at({0, 0}).submap->cloud, map.nodes.at({0, 0}).cloud.get()}) {
    ASSERT_EQ(left->size(), 1u);
    EXPECT_EQ(left->positions[0].x(), 1.5f);
  }
}

TEST(RemoveTransientTest, WhatIsOutOfScopeBearsWitnessOnly) {
  const Map before = VisitedMap({{0., {"CCC"}, 0}, {0., {"RRC"}, 1}, {0., {"..R"}, 2}});
  proto::FilterOptions where;
  where.add_trajectories(1);
  Map map = before;
  Remove(SharpTransientOptions(), &map, where);
  EXPECT_THAT(HitsOf("car", map, {0, 0}, 3, 1), ElementsAre("###"));
  EXPECT_THAT(HitsOf("car", map, {1, 0}, 3, 1), ElementsAre("..."));
  where.Clear();
  for (const double number : {1., 0., 9., 9.}) where.add_box(number);
  map = before;
  Remove(SharpTransientOptions(), &map, where);
  EXPECT_THAT(HitsOf("car", map, {0, 0}, 3, 1), ElementsAre("#.."));
}

// The second visit's car speaks against calling cell 0 free, until the third one has it removed.
TEST(RemoveTransientTest, IsRepeatedUntilNothingGoes) {
  proto::TransientOptions options = SharpTransientOptions();
  options.set_tolerance_m(1.);
  Map map = VisitedMap({{0., {"C...."}}, {100., {"RC..."}}, {200., {"..R.."}}});
  Remove(options, &map);
  EXPECT_THAT(HitsOf("car", map, {0, 1}, 5, 1), ElementsAre("....."));
  EXPECT_THAT(HitsOf("car", map, {0, 0}, 5, 1), ElementsAre("....."));
}

Map RandomVisits(int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0., 1.);
  Map map = semantic_kiss_testing::EmptyMap();
  for (int i = 0; i < 8; ++i) {
    Sketch sketch(20, std::string(20, '.'));
    for (std::string& row : sketch) {
      for (char& cell : row) {
        if (uniform(random) < 0.6) cell = "RRRRSCcUB"[random() % 9];
      }
    }
    AddVisitingSubmap(
        {10. * static_cast<double>(random() % 20) + 200. * i, sketch,
         static_cast<int>(random() % 2),
         PlanarPose(5. * uniform(random), 5. * uniform(random), 6. * uniform(random))},
        &map);
  }
  return map;
}

TEST(RemoveTransientTest, TwiceIsOnce) {
  proto::TransientOptions options = SharpTransientOptions();
  options.set_max_movable_share(0.4);
  int num_changed = 0;
  for (int seed = 0; seed < 12; ++seed) {
    options.set_tolerance_m(seed % 3);
    const Map before = RandomVisits(seed);
    Map once = before;
    Remove(options, &once);
    Map twice = once;
    Remove(options, &twice);
    for (const auto& [id, placed] : once.submaps) {
      EXPECT_EQ(placed.submap, twice.submaps.at(id).submap) << "seed " << seed;
      num_changed += placed.submap != before.submaps.at(id).submap;
    }
  }
  EXPECT_GT(num_changed, 20);
}

}  // namespace
}  // namespace cartographer::map
