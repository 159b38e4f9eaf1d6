// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "cartographer/map/remove_cells.h"
#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::SmallMap;
using ::testing::IsEmpty;

TEST(PlacesTest, AnEmptyMapHasNone) {
  EXPECT_THAT(ViewersOf(Map()), IsEmpty());
  EXPECT_THAT(PlacesOf(Map(), {}, {}, {16, 0}), IsEmpty());
  EXPECT_EQ(CellSide_m({}), 0.);
}

TEST(PlacesTest, ViewersKnowWhenTheySawAndWhere) {
  const Map map = SmallMap(5, 3);
  const std::vector<Viewer> viewers = ViewersOf(map);
  ASSERT_EQ(viewers.size(), map.submaps.size());
  // Nodes 5 and 6 lie in submap 1.
  EXPECT_EQ(viewers[1].id, (submap::SubmapId{1, 1}));
  EXPECT_EQ(viewers[1].first_time, map.nodes.at({1, 5}).time);
  EXPECT_EQ(viewers[1].last_time, map.nodes.at({1, 6}).time);
  EXPECT_EQ(viewers[2].first_time, viewers[2].last_time);
  EXPECT_EQ(viewers[1].height_m, map.submaps.at({1, 1}).map_from_submap.translation().z());
  EXPECT_EQ(CellSide_m(viewers), 0.25);
}

TEST(PlacesTest, WithoutNodesThereAreNoTimes) {
  Map map = SmallMap(1, 3);
  map.constraints.clear();
  EXPECT_FALSE(ViewersOf(map)[0].first_time.has_value());
}

// Every hit is listed in the place that it lies in, and in those whose margin it lies in.
TEST(PlacesTest, NoHitIsMissed) {
  const Map map = SmallMap(4, 100);
  const std::vector<Viewer> viewers = ViewersOf(map);
  sensor::LabelMask labels;
  labels.Insert(sensor::Label{1});
  labels.Insert(sensor::Label{3});
  constexpr int kSide = 40, kMargin = 3;
  std::set<std::tuple<int, int, int, int, int, int>> listed;
  for (const Place& place : PlacesOf(map, viewers, labels, {kSide, kMargin})) {
    EXPECT_EQ(place.min.x() % kSide, 0);
    int previous = 0;
    for (const Place::SeenTile& tile : place.tiles) {
      EXPECT_TRUE(labels.Contains(tile.label));
      EXPECT_GE(tile.viewer, previous);
      previous = tile.viewer;
      EXPECT_TRUE(listed
                      .emplace(place.min.x(), place.min.y(), tile.viewer,
                               static_cast<int>(tile.label), tile.index.x, tile.index.y)
                      .second)
          << "listed twice";
    }
  }
  const auto place_of = [](int cell) {
    return static_cast<int>(std::floor(1. * cell / kSide)) * kSide;
  };
  int num_hits = 0;
  for (size_t i = 0; i < viewers.size(); ++i) {
    const MapSubmap& placed = map.submaps.at(viewers[i].id);
    for (const sensor::Label label : {sensor::Label{1}, sensor::Label{3}}) {
      for (const auto& [index, tile] : placed.submap->grid.LayerOf(label)) {
        for (int cell = 0; cell < 256; ++cell) {
          if (tile->hits[cell] == 0) continue;
          const Eigen::Vector2d position =
              MapFromGrid(placed) *
              placed.submap->grid.CenterOf({index.x * 16 + cell % 16, index.y * 16 + cell / 16});
          const submap::CellIndex in_map = (position.array() / 0.25).floor().cast<int>();
          for (const int dx : {-kMargin, 0, kMargin}) {
            for (const int dy : {-kMargin, 0, kMargin}) {
              EXPECT_EQ(
                  listed.count({place_of(in_map.x() + dx), place_of(in_map.y() + dy),
                                static_cast<int>(i), static_cast<int>(label), index.x, index.y}),
                  1u);
            }
          }
          ++num_hits;
        }
      }
    }
  }
  EXPECT_GT(num_hits, 100);
}

TEST(PlacesTest, AbsurdDistancesAreLeftOut) {
  Map map = SmallMap(1, 10);
  for (auto& [id, placed] : map.submaps) {
    placed.map_from_submap = transform::Rigid3d::Translation({1e300, 0., 0.});
  }
  sensor::LabelMask labels;
  labels.Insert(sensor::Label{1});
  EXPECT_THAT(PlacesOf(map, ViewersOf(map), labels, {16, 1}), IsEmpty());
}

}  // namespace
}  // namespace cartographer::map
