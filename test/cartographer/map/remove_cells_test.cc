// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glog/logging.h"
#include "test/testing/map_sketch.h"
#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::SubmapFromSketch;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const CellRule kAlways = [](sensor::Label, const submap::CellIndex&, int) { return true; };

LostCells Remove(const proto::FilterOptions& options, const char* label, const CellRule& rule,
                 Map* map) {
  const auto scope = FilterScope::Create(options, *map);
  CHECK(scope.ok()) << scope.status();
  sensor::LabelMask labels;
  labels.Insert(SketchLabel(label));
  return RemoveCells(
      *scope, labels, [&](const submap::SubmapId&) { return rule; }, map);
}

const submap::SemanticGrid& GridOf(const Map& map, int index = 0) {
  return map.submaps.at({0, index}).submap->grid;
}

TEST(RemoveCellsTest, TakesHitsOfTheLabelAlone) {
  Map map = MapFromSketch({"RCC", "RRB"}, 1., 3);
  AddSubmap(SubmapFromSketch({"RCC"}, 1., 1), transform::Rigid3d(), &map);
  const LostCells lost = Remove({}, "car", kAlways, &map);
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost.at({0, 0}).Hits(SketchLabel("car"), {1, 1}), 3);
  EXPECT_EQ(GridOf(map).Dominant({1, 1}).hits, 0);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("road"), {0, 1}), 3);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("building"), {2, 0}), 3);
  EXPECT_THAT(GridOf(map, 1).Labels(), ElementsAre(SketchLabel("road")));
}

TEST(RemoveCellsTest, UncoversWhatLayBeneath) {
  Map map = MapFromSketch({"C"}, 1., 9);
  auto both = std::make_shared<submap::Submap>(*map.submaps.at({0, 0}).submap);
  both->grid.AddHits(SketchLabel("road"), {0, 0}, 2);
  map.submaps[{0, 0}].submap = both;
  EXPECT_EQ(GridOf(map).Dominant({0, 0}).label, SketchLabel("car"));
  Remove({}, "car", kAlways, &map);
  EXPECT_EQ(GridOf(map).Dominant({0, 0}).label, SketchLabel("road"));
  EXPECT_EQ(GridOf(map).Dominant({0, 0}).hits, 2);
}

TEST(RemoveCellsTest, RulesAreAskedForCellsWithHits) {
  Map map = EmptyMap();
  auto submap = std::make_shared<submap::Submap>(1.);
  submap->grid.AddHits(SketchLabel("car"), {-17, 30}, 2);
  submap->grid.AddHits(SketchLabel("car"), {-16, 30}, 3);
  AddSubmap(submap, transform::Rigid3d(), &map);
  Remove(
      {}, "car",
      [](sensor::Label label, const submap::CellIndex& cell, int hits) {
        EXPECT_EQ(label, SketchLabel("car"));
        EXPECT_EQ(cell.y(), 30);
        EXPECT_EQ(cell.x(), hits == 2 ? -17 : -16);
        return hits < 3;
      },
      &map);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("car"), {-17, 30}), 0);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("car"), {-16, 30}), 3);
}

TEST(RemoveCellsTest, CellsAreInTheRegionByTheirCentresInTheMap) {
  Map map = EmptyMap();
  // Turned by 90 degrees: cell (x, y) has its centre at (10 - y - 0.5, 20 + x + 0.5).
  AddSubmap(SubmapFromSketch({"CC", "CC"}, 1.), PlanarPose(10., 20., M_PI / 2), &map);
  proto::FilterOptions options;
  for (const double number : {8.4, 20.4, 8.6, 20.6}) options.add_box(number);
  Remove(options, "car", kAlways, &map);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("car"), {0, 1}), 0);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("car"), {0, 0}), 1);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("car"), {1, 0}), 1);
  EXPECT_EQ(GridOf(map).Hits(SketchLabel("car"), {1, 1}), 1);
}

TEST(RemoveCellsTest, WhatLosesNothingStaysTheSameObject) {
  Map map = MapFromSketch({"RCC"}, 1.);
  AddSubmap(SubmapFromSketch({"RRB"}, 1.), transform::Rigid3d(), &map);
  const Map before = map;
  EXPECT_THAT(Remove({}, "sidewalk", kAlways, &map), IsEmpty());
  EXPECT_THAT(Remove({}, "car", nullptr, &map), IsEmpty());
  for (const auto& [id, placed] : map.submaps) {
    EXPECT_EQ(placed.submap, before.submaps.at(id).submap);
  }
  Remove({}, "car", kAlways, &map);
  EXPECT_NE(map.submaps.at({0, 0}).submap, before.submaps.at({0, 0}).submap);
  EXPECT_EQ(map.submaps.at({0, 1}).submap, before.submaps.at({0, 1}).submap);
  EXPECT_EQ(GridOf(before).Hits(SketchLabel("car"), {1, 0}), 1) << "others keep their map";
}

// Every other cell of one label: what stays and what goes make up the whole, tile by tile.
TEST(RemoveCellsTest, NothingIsLostInBetween) {
  const Map before = SmallMap(4, 300);
  Map map = before;
  const auto scope = FilterScope::Create({}, map);
  sensor::LabelMask labels;
  labels.Insert(sensor::Label{2});
  const LostCells lost = RemoveCells(
      *scope, labels,
      [](const submap::SubmapId&) -> CellRule {
        return [](sensor::Label, const submap::CellIndex& cell, int) {
          return (cell.x() + cell.y()) % 2 == 0;
        };
      },
      &map);
  for (const auto& [id, placed] : before.submaps) {
    const submap::SemanticGrid& kept = map.submaps.at(id).submap->grid;
    EXPECT_EQ(placed.submap->cloud.positions, map.submaps.at(id).submap->cloud.positions);
    for (const sensor::Label label : placed.submap->grid.Labels()) {
      for (const auto& [index, tile] : placed.submap->grid.LayerOf(label)) {
        for (int i = 0; i < 256; ++i) {
          const submap::CellIndex cell(index.x * 16 + i % 16, index.y * 16 + i / 16);
          const bool goes = label == sensor::Label{2} && (cell.x() + cell.y()) % 2 == 0;
          EXPECT_EQ(kept.Hits(label, cell), goes ? 0 : tile->hits[i]);
          EXPECT_EQ(lost.at(id).Hits(label, cell), goes ? tile->hits[i] : 0);
        }
      }
    }
  }
}

TEST(RemoveCellsTest, PlacesOfGridsIgnoreTilt) {
  MapSubmap placed;
  placed.map_from_submap =
      transform::Rigid3d({1., 2., 3.}, Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) *
                                           Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  const Eigen::Vector2d expected(1. + std::cos(0.5), 2. + std::sin(0.5));
  EXPECT_LT((MapFromGrid(placed) * Eigen::Vector2d(1., 0.) - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace cartographer::map
