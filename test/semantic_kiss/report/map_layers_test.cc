// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/map_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/map_sketch.h"
#include "test/testing/small_map.h"

namespace semantic_kiss::report {
namespace {

using cartographer::io::proto::RenderOptions;
using cartographer::map::Map;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SmallMap;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

proto::ReportOptions Options() {
  proto::ReportOptions options;
  options.set_max_side_px(1000);
  options.set_max_pictures_mb(10.);
  options.set_tile_side_px(32);
  return options;
}

std::vector<std::string> Names(const MapLayers& map) {
  std::vector<std::string> names;
  for (const MapLayer& layer : map.layers) names.push_back(layer.group + ": " + layer.name);
  return names;
}

size_t Bytes(const MapLayers& map) {
  size_t bytes = 0;
  for (const MapLayer& layer : map.layers) {
    for (const LayerTile& tile : layer.tiles) bytes += tile.png.size();
  }
  return bytes;
}

TEST(MapLayersTest, LayersComeFromTheGroundUp) {
  const Map map = MapFromSketch({"PCBUSR"}, 0.5);
  const auto maps = TakeApart({&map}, RenderOptions(), Options());
  ASSERT_TRUE(maps.ok()) << maps.status();
  const MapLayers& layers = maps->front();
  EXPECT_THAT(Names(layers),
              ElementsAre("Ground: road", "Ground: sidewalk", "Unlabeled: unlabeled",
                          "Standing: building", "Movable: car", "Landmarks: traffic-sign"));
  EXPECT_EQ(layers.frame.resolution_m, 0.5);
  EXPECT_EQ(layers.tile_side_px, 32);
  EXPECT_EQ(layers.layers[4].color.blue, 240);
}

TEST(MapLayersTest, HiddenLabelsAreNotThere) {
  const Map map = MapFromSketch({"PCBUSR"}, 0.5);
  RenderOptions image;
  image.add_hide("car");
  image.add_hide("unlabeled");
  EXPECT_EQ(TakeApart({&map}, image, Options())->front().layers.size(), 4u);
  image.add_hide("cra");
  EXPECT_THAT(TakeApart({&map}, image, Options()).status().message(), HasSubstr("cra"));
}

TEST(MapLayersTest, MapsSideBySideHaveOneResolution) {
  const Map small = MapFromSketch({"RB"}, 0.5);
  const Map large = MapFromSketch(Sketch(90, std::string(90, 'R')), 0.5);
  proto::ReportOptions options = Options();
  options.set_max_side_px(50);
  const auto maps = TakeApart({&small, &large}, RenderOptions(), options);
  ASSERT_TRUE(maps.ok()) << maps.status();
  EXPECT_GT((*maps)[0].frame.resolution_m, 0.5);
  EXPECT_EQ((*maps)[0].frame.resolution_m, (*maps)[1].frame.resolution_m);
  EXPECT_LE((*maps)[1].frame.width, 50);
}

TEST(MapLayersTest, ASmallBudgetMakesCoarserPictures) {
  const Map map = SmallMap(12, 4000);
  proto::ReportOptions options = Options();
  const MapLayers fine = TakeApart({&map}, RenderOptions(), options)->front();
  const double budget_mb = Bytes(fine) / 2.5e6;
  options.set_max_pictures_mb(budget_mb);
  const MapLayers coarse = TakeApart({&map}, RenderOptions(), options)->front();
  EXPECT_LE(Bytes(coarse), budget_mb * 1e6);
  EXPECT_GT(coarse.frame.resolution_m, fine.frame.resolution_m);
  EXPECT_EQ(Names(coarse), Names(fine));
}

TEST(MapLayersTest, NothingToDrawIsAnError) {
  const Map empty = EmptyMap();
  EXPECT_THAT(TakeApart({&empty}, RenderOptions(), Options()).status().message(),
              HasSubstr("nothing to draw"));
}

}  // namespace
}  // namespace semantic_kiss::report
