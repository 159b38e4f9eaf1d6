// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/semantic_raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "test/cartographer/io/on_threads.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SketchOf;
using semantic_kiss_testing::SubmapFromSketch;
using semantic_kiss_testing::WholeFrame;
using submap::CellIndex;
using submap::SemanticGrid;

// As many pixels as the sketch has cells, on top of them.
RasterFrame FrameOn(const Sketch& sketch, double resolution_m) {
  return {resolution_m, 0., sketch.size() * resolution_m, static_cast<int>(sketch.front().size()),
          static_cast<int>(sketch.size())};
}

TEST(SemanticRasterTest, DrawsAGridAsItIs) {
  const Sketch sketch{"BBBBB", "B.R.P", "CU..S"};
  const SemanticRaster raster =
      ComposeRaster(MapFromSketch(sketch, 0.25, 3), {}, FrameOn(sketch, 0.25));
  EXPECT_EQ(SketchOf(raster), sketch);
  EXPECT_EQ(raster.hits[0], 3.f);
}

TEST(SemanticRasterTest, SmallPixelsShareACellsHits) {
  const Sketch sketch{"BR"};
  const SemanticRaster raster =
      ComposeRaster(MapFromSketch(sketch, 1., 16), {}, RasterFrame{0.25, 0., 1., 8, 4});
  EXPECT_EQ(SketchOf(raster), Sketch(4, "BBBBRRRR"));
  EXPECT_EQ(std::accumulate(raster.hits.begin(), raster.hits.end(), 0.f), 32.f);
}

TEST(SemanticRasterTest, LargePixelsSumCells) {
  const SemanticRaster raster =
      ComposeRaster(MapFromSketch({"RRRB", "RRBB"}, 0.5), {}, RasterFrame{1., 0., 1., 2, 1});
  EXPECT_EQ(SketchOf(raster), Sketch{"RB"});
  EXPECT_EQ(raster.hits, (std::vector<float>{4.f, 3.f}));
}

TEST(SemanticRasterTest, TheSumOverSubmapsDecides) {
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch({"BB"}, 1., 3), transform::Rigid3d(), &map);
  AddSubmap(SubmapFromSketch({"RR"}, 1., 2), transform::Rigid3d(), &map);
  AddSubmap(SubmapFromSketch({".R"}, 1., 2), transform::Rigid3d(), &map);
  const SemanticRaster raster = ComposeRaster(map, {}, RasterFrame{1., 0., 1., 2, 1});
  EXPECT_EQ(SketchOf(raster), Sketch{"BR"});
  EXPECT_EQ(raster.hits, (std::vector<float>{3.f, 4.f}));
}

TEST(SemanticRasterTest, UnlabeledYields) {
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch({"UU"}, 1., 9), transform::Rigid3d(), &map);
  AddSubmap(SubmapFromSketch({".P"}, 1., 1), transform::Rigid3d(), &map);
  EXPECT_EQ(SketchOf(ComposeRaster(map, {}, RasterFrame{1., 0., 1., 2, 1})), Sketch{"UP"});
}

TEST(SemanticRasterTest, HiddenLabelsUncoverWhatLiesBeneath) {
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch({"CCC"}, 1., 5), transform::Rigid3d(), &map);
  AddSubmap(SubmapFromSketch({"RS."}, 1., 1), transform::Rigid3d(), &map);
  const RasterFrame frame{1., 0., 1., 3, 1};
  EXPECT_EQ(SketchOf(ComposeRaster(map, {}, frame)), Sketch{"CCC"});
  sensor::LabelMask hidden;
  hidden.Insert(SketchLabel("car"));
  EXPECT_EQ(SketchOf(ComposeRaster(map, hidden, frame)), Sketch{"RS."});
}

TEST(SemanticRasterTest, TurnedSubmapsHaveNoHoles) {
  const auto submap = SubmapFromSketch(Sketch(60, std::string(90, 'R')), 0.2);  // 18 m x 12 m
  for (const double yaw : {0.01, 0.5, M_PI / 4., 2., -1.3}) {
    for (const double resolution_m : {0.07, 0.15, 0.2, 0.21, 0.27, 0.3, 0.5}) {
      map::Map map = EmptyMap();
      AddSubmap(submap, PlanarPose(3.3, -7.1, yaw), &map);
      const SemanticRaster raster = ComposeRaster(map, {}, WholeFrame(map, resolution_m));
      for (int row = 0; row < raster.frame.height; ++row) {
        for (int column = 0; column < raster.frame.width; ++column) {
          const Eigen::Vector2d center = raster.frame.MapFromPixel({column + 0.5, row + 0.5});
          const Eigen::Vector3d inside =
              PlanarPose(3.3, -7.1, yaw).inverse() * Eigen::Vector3d(center.x(), center.y(), 0.);
          // How far the pixel lies within the rectangle; pixels across its edge may go either way.
          const double depth =
              std::min({inside.x(), 18. - inside.x(), inside.y(), 12. - inside.y()});
          const bool drawn = raster.hits[raster.IndexOf(column, row)] > 0.f;
          if (std::abs(depth) < resolution_m) continue;
          ASSERT_EQ(drawn, depth > 0.) << yaw << " " << resolution_m;
        }
      }
    }
  }
}

TEST(SemanticRasterTest, HitsOfAnAreaDoNotDependOnResolution) {
  const auto submap = SubmapFromSketch(Sketch(100, std::string(100, 'R')), 0.2, 2);
  map::Map map = EmptyMap();
  AddSubmap(submap, PlanarPose(0., 0., 0.4), &map);
  for (const double resolution_m : {0.05, 0.1, 0.19, 0.2, 0.22, 0.28, 0.4, 1.}) {
    const SemanticRaster raster = ComposeRaster(map, {}, WholeFrame(map, resolution_m));
    const double sum = std::accumulate(raster.hits.begin(), raster.hits.end(), 0.);
    EXPECT_NEAR(sum, 20000., 200.) << resolution_m;
  }
}

// A map of random hits in overlapping, turned submaps.
map::Map RandomMap(std::mt19937* random) {
  std::uniform_int_distribution<int> cell(-40, 39), hits(1, 4), label(0, 4);
  std::uniform_real_distribution<double> offset(-3., 3.), yaw(-M_PI, M_PI);
  map::Map map = EmptyMap();
  for (int i = 0; i < 5; ++i) {
    auto submap = std::make_shared<submap::Submap>(i < 3 ? 0.2 : 0.35);
    for (int j = 0; j < 4000; ++j) {
      submap->grid.AddHits(sensor::Label{static_cast<uint8_t>(label(*random))},
                           {cell(*random), cell(*random)}, hits(*random));
    }
    AddSubmap(submap, PlanarPose(offset(*random), offset(*random), yaw(*random)), &map);
  }
  return map;
}

// The dominant label at a position by looking into every submap; `certain` is false where the
// position is so close to a cell's border that round-off decides.
SemanticGrid::DominantLabel LookUp(const map::Map& map, const Eigen::Vector2d& position,
                                   bool* certain) {
  std::vector<double> sums(map.labels.size());
  for (const auto& [id, placed] : map.submaps) {
    const SemanticGrid& grid = placed.submap->grid;
    const Eigen::Vector3d inside = placed.map_from_submap.inverse() *
                                   Eigen::Vector3d(position.x(), position.y(), 0.) /
                                   grid.resolution_m();
    const CellIndex cell(std::floor(inside.x()), std::floor(inside.y()));
    for (int axis = 0; axis < 2; ++axis) {
      *certain = *certain && std::abs(inside[axis] - std::round(inside[axis])) > 1e-6;
    }
    for (int i = 0; i < sums.size(); ++i) {
      // Hits per square metre, since the grids' cells differ in size.
      sums[i] += grid.Hits(sensor::Label{static_cast<uint8_t>(i)}, cell) /
                 (grid.resolution_m() * grid.resolution_m());
    }
  }
  int best = 0;
  for (int i = 1; i < sums.size(); ++i) {
    if (sums[i] > 0. && (best == 0 || sums[i] > sums[best] * (1. + 1e-9))) best = i;
    if (best != i && best != 0 && std::abs(sums[i] - sums[best]) < 1e-3) *certain = false;
  }
  return {sensor::Label{static_cast<uint8_t>(best)}, sums[best] > 0. ? 1 : 0};
}

TEST(SemanticRasterTest, EqualsLookingUpEveryPixel) {
  for (const int seed : {1, 2, 3}) {
    std::mt19937 random(seed);
    const map::Map map = RandomMap(&random);
    const SemanticRaster raster = ComposeRaster(map, {}, WholeFrame(map, 0.1));
    int checked = 0;
    for (int row = 0; row < raster.frame.height; ++row) {
      for (int column = 0; column < raster.frame.width; ++column) {
        bool certain = true;
        const auto expected =
            LookUp(map, raster.frame.MapFromPixel({column + 0.5, row + 0.5}), &certain);
        if (!certain) continue;
        const size_t index = raster.IndexOf(column, row);
        ASSERT_EQ(raster.hits[index] > 0.f, expected.hits > 0) << column << " " << row;
        ASSERT_EQ(raster.labels[index], expected.label) << column << " " << row;
        checked += expected.hits;
      }
    }
    EXPECT_GT(checked, 10000);
  }
}

TEST(SemanticRasterTest, ThreadsDoNotShow) {
  std::mt19937 random(7);
  const map::Map map = RandomMap(&random);
  const RasterFrame frame = WholeFrame(map, 0.03);
  const auto one = OnThreads(1, [&] { return ComposeRaster(map, {}, frame); });
  const auto four = OnThreads(4, [&] { return ComposeRaster(map, {}, frame); });
  EXPECT_EQ(one.labels, four.labels);
  EXPECT_EQ(one.hits, four.hits);
}

TEST(SemanticRasterTest, WhatLiesOutsideOfTheFrameIsLeftOut) {
  map::Map map = MapFromSketch({"RRRR", "BBBB"}, 1.);
  AddSubmap(SubmapFromSketch({"C"}, 1.), PlanarPose(1e12, -1e12, 0.), &map);
  EXPECT_EQ(SketchOf(ComposeRaster(map, {}, RasterFrame{1., 2., 5., 3, 4})),
            (Sketch{"...", "...", "...", "RR."}));
}

}  // namespace
}  // namespace cartographer::io
