// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddNode;
using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SubmapFromSketch;
using semantic_kiss_testing::WholeFrame;
using ::testing::HasSubstr;

TEST(RasterFrameTest, RowsRunAgainstY) {
  const RasterFrame frame{0.5, -10., 20., 100, 50};
  EXPECT_EQ(frame.PixelFromMap({-10., 20.}), Eigen::Vector2d(0., 0.));
  EXPECT_EQ(frame.PixelFromMap({-9., 19.5}), Eigen::Vector2d(2., 1.));
  EXPECT_EQ(frame.MapFromPixel({100., 50.}), Eigen::Vector2d(40., -5.));
  EXPECT_EQ(frame.MapFromPixel(frame.PixelFromMap({3., 4.})), Eigen::Vector2d(3., 4.));
  EXPECT_EQ(frame.size(), 5000);
}

TEST(RasterFrameTest, ContainsEveryCellOfTurnedSubmaps) {
  for (const double yaw : {0., 0.3, 1.57, -2.8}) {
    map::Map map = EmptyMap();
    const auto submap = SubmapFromSketch(Sketch(20, std::string(35, 'B')), 0.3);
    AddSubmap(submap, PlanarPose(100., -50., yaw), &map);
    const RasterFrame frame = WholeFrame(map, 0.1);
    EXPECT_DOUBLE_EQ(frame.resolution_m, 0.1);
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(0., 0.), {10.5, 0.}, {0., 6.}, {10.5, 6.}}) {
      const Eigen::Vector3d in_map =
          PlanarPose(100., -50., yaw) * Eigen::Vector3d(corner.x(), corner.y(), 0.);
      const Eigen::Vector2d pixel = frame.PixelFromMap(in_map.head<2>());
      EXPECT_GE(pixel.minCoeff(), 0.) << yaw;
      EXPECT_LE(pixel.x(), frame.width) << yaw;
      EXPECT_LE(pixel.y(), frame.height) << yaw;
    }
  }
}

TEST(RasterFrameTest, ResolutionIsHalfTheFinestGridsByDefault) {
  map::Map map = MapFromSketch({"R"}, 0.4);
  EXPECT_DOUBLE_EQ(WholeFrame(map, 0.).resolution_m, 0.2);
  AddSubmap(SubmapFromSketch({"R"}, 0.1), transform::Rigid3d(), &map);
  EXPECT_DOUBLE_EQ(WholeFrame(map, 0.).resolution_m, 0.05);
}

TEST(RasterFrameTest, HugeExtentsCoarsenTheResolution) {
  for (const double distance_m : {1e3, 1e7, 1e100}) {
    map::Map map = MapFromSketch({"R"}, 0.1);
    AddSubmap(SubmapFromSketch({"R"}, 0.1), PlanarPose(distance_m, 0., 0.), &map);
    const auto frame = FrameOf(map, {}, {0.05, 500, 0.});
    ASSERT_TRUE(frame.ok()) << frame.status();
    EXPECT_EQ(frame->width, 500);
    EXPECT_GE(frame->height, 1);
    EXPECT_LE(frame->height, 500);
    EXPECT_NEAR(frame->resolution_m * 500 / distance_m, 1., 0.01);
  }
}

TEST(RasterFrameTest, CropsLoneTilesButNoTrajectory) {
  map::Map map = MapFromSketch(Sketch(160, std::string(160, 'R')), 0.1);  // 100 tiles
  AddSubmap(SubmapFromSketch({"B"}, 0.1), PlanarPose(500., 0., 0.), &map);
  const RasterFrameOptions options{0.1, 20000, 0.02};
  EXPECT_GT(WholeFrame(map, 0.5).width, 1000);
  const auto cropped = FrameOf(map, {}, options);
  ASSERT_TRUE(cropped.ok());
  EXPECT_NEAR(cropped->width, 160, 25);
  EXPECT_NEAR(cropped->height, 160, 25);

  AddNode({-100., 8., 0.}, &map);
  const auto with_node = FrameOf(map, {}, options);
  ASSERT_TRUE(with_node.ok());
  EXPECT_GT(with_node->PixelFromMap({-100., 8.}).x(), 0.);
}

TEST(RasterFrameTest, UnlabeledHitsCountOnlyWhereThereIsNothingElse) {
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch({"U"}, 0.1), PlanarPose(300., 0., 0.), &map);
  EXPECT_NEAR(WholeFrame(map, 0.1).min_x, 300., 3.);
  AddSubmap(SubmapFromSketch({"R"}, 0.1), PlanarPose(0., 0., 0.), &map);
  EXPECT_LT(WholeFrame(map, 0.1).width, 50);
}

TEST(RasterFrameTest, NothingToDrawIsAnError) {
  const RasterFrameOptions options{0.1, 100, 0.};
  map::Map map = EmptyMap();
  EXPECT_EQ(FrameOf(map, {}, options).status().message(),
            "the map has nothing to draw: none of its submaps' grids has a hit");
  AddSubmap(SubmapFromSketch({"."}, 0.1), transform::Rigid3d(), &map);
  EXPECT_FALSE(FrameOf(map, {}, options).ok());

  AddSubmap(SubmapFromSketch({"C"}, 0.1), transform::Rigid3d(), &map);
  EXPECT_TRUE(FrameOf(map, {}, options).ok());
  sensor::LabelMask hidden;
  hidden.Insert(SketchLabel("car"));
  EXPECT_EQ(FrameOf(map, hidden, options).status().message(),
            "the map has nothing to draw: no grid has a hit of a label that is shown");
}

TEST(RasterFrameTest, PosesThatAreNotFiniteAreAnError) {
  map::Map map = MapFromSketch({"R"}, 0.1);
  AddSubmap(SubmapFromSketch({"R"}, 0.1), PlanarPose(std::nan(""), 0., 0.), &map);
  EXPECT_THAT(std::string(FrameOf(map, {}, {0.1, 100, 0.}).status().message()),
              HasSubstr("submap 0/1 of the map has a pose that is not finite"));
}

TEST(RasterFrameTest, ExtentsThatOverflowAreAnError) {
  map::Map map = EmptyMap();
  for (const double x : {-1.5e308, 1.5e308}) {
    AddSubmap(SubmapFromSketch({"R"}, 0.1), PlanarPose(x, 0., 0.), &map);
  }
  EXPECT_THAT(std::string(FrameOf(map, {}, {0.1, 100, 0.}).status().message()),
              HasSubstr("farther apart than numbers can tell"));
}

TEST(RasterFrameTest, NodesThatAreNotFiniteArePassedOver) {
  map::Map map = MapFromSketch({"R"}, 0.1);
  const int width = WholeFrame(map, 0.1).width;
  AddNode({std::numeric_limits<double>::infinity(), 0., 0.}, &map);
  EXPECT_EQ(WholeFrame(map, 0.1).width, width);
}

}  // namespace
}  // namespace cartographer::io
