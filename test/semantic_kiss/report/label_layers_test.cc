// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/label_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "cartographer/io/semantic_raster.h"
#include "test/testing/map_sketch.h"

namespace semantic_kiss::report {
namespace {

using cartographer::io::RasterFrame;
using cartographer::map::Map;
using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SketchLabels;
using semantic_kiss_testing::SubmapFromSketch;
using ::testing::IsEmpty;

using Layers = std::map<Label, AlphaImage>;

RasterFrame FrameOn(const Sketch& sketch) {
  return {1., 0., static_cast<double>(sketch.size()), static_cast<int>(sketch.front().size()),
          static_cast<int>(sketch.size())};
}

Layers LayersOf(const Map& map, const RasterFrame& frame, const LabelLayersOptions& options = {}) {
  Layers layers;
  DrawLabelLayers(map, frame, options, [&](Label label, AlphaImage image) {
    EXPECT_TRUE(layers.emplace(label, std::move(image)).second);
  });
  return layers;
}

// 'x' where a layer has a pixel.
Sketch Shape(const Layers& layers, const std::string& name) {
  const auto found = layers.find(SketchLabel(name));
  if (found == layers.end()) return {};
  Sketch sketch;
  for (int row = 0; row < found->second.height; ++row) {
    sketch.emplace_back();
    for (int column = 0; column < found->second.width; ++column) {
      sketch.back().push_back(found->second.Row(row)[column] > 0 ? 'x' : '.');
    }
  }
  return sketch;
}

// Two sketches upon each other, with as many hits a cell as given.
Map Upon(const Sketch& one, int hits, const Sketch& other, int other_hits) {
  Map map = MapFromSketch(one, 1., hits);
  AddSubmap(SubmapFromSketch(other, 1., other_hits), PlanarPose(0., 0., 0.), &map);
  return map;
}

TEST(LabelLayersTest, AnEmptyMapHasNoLayers) {
  EXPECT_THAT(LayersOf(semantic_kiss_testing::EmptyMap(), FrameOn({"...."})), IsEmpty());
}

TEST(LabelLayersTest, WhatStandsLiesOnTheGround) {
  const Sketch road{"RRRR"}, cars{".CC."};
  const Layers layers = LayersOf(Upon(road, 1, cars, 2), FrameOn(road));
  EXPECT_EQ(Shape(layers, "car"), Sketch{".xx."});
  EXPECT_EQ(Shape(layers, "road"), Sketch{"xxxx"});  // without the cars, the road shows
}

TEST(LabelLayersTest, WhatWasSeenLessIsNotDrawn) {
  const Sketch road{"RRRR"}, cars{".CC."};
  EXPECT_EQ(Shape(LayersOf(Upon(road, 3, cars, 2), FrameOn(road)), "car"), Sketch{});
}

TEST(LabelLayersTest, GapsAreFilledUnderCars) {
  const Sketch sketch{"RCCR"};
  const Layers layers = LayersOf(MapFromSketch(sketch, 1.), FrameOn(sketch), {{}, 3.});
  EXPECT_EQ(Shape(layers, "road"), Sketch{"xxxx"});
  EXPECT_EQ(Shape(layers, "car"), Sketch{".xx."});
}

TEST(LabelLayersTest, UnlabeledShowsWhereNothingElseIs) {
  const Sketch unlabeled{"UUUU"}, rest{"R.B."};
  const Layers layers = LayersOf(Upon(unlabeled, 9, rest, 1), FrameOn(rest));
  EXPECT_EQ(Shape(layers, "unlabeled"), Sketch{".x.x"});
}

TEST(LabelLayersTest, AMapWithoutLabelsIsShadedByHits) {
  const Sketch floor{"UUU"}, wall{"..U"};
  const Layers layers = LayersOf(Upon(floor, 1, wall, 20), FrameOn(floor));
  const AlphaImage& image = layers.at(kUnlabeled);
  EXPECT_EQ(image.levels[0], image.levels[1]);
  EXPECT_LT(image.levels[1], image.levels[2]);
}

TEST(LabelLayersTest, LandmarksGetAMark) {
  const Sketch sketch{"....", ".P..", "...."};
  EXPECT_EQ(Shape(LayersOf(MapFromSketch(sketch, 1.), FrameOn(sketch)), "traffic-sign"),
            (Sketch{".x..", "xxx.", ".x.."}));
}

TEST(LabelLayersTest, LandmarksShowHoweverLittleWasSeenOfThem) {
  const Sketch road{"RRR"}, sign{".P."};
  EXPECT_EQ(Shape(LayersOf(Upon(road, 99, sign, 1), FrameOn(road)), "traffic-sign"), Sketch{"xxx"});
}

TEST(LabelLayersTest, HiddenLabelsGetNoLayer) {
  const Sketch road{"RRRR"}, cars{".CC."};
  LabelLayersOptions options;
  options.hidden.Insert(SketchLabel("car"));
  const Layers layers = LayersOf(Upon(road, 1, cars, 2), FrameOn(road), options);
  EXPECT_EQ(layers.size(), 1u);
  EXPECT_EQ(Shape(layers, "road"), Sketch{"xxxx"});
}

TEST(LabelLayersTest, MoreHitsAreMoreOpaque) {
  const Sketch building{"BBB"}, more{"..B"};
  const Layers layers = LayersOf(Upon(building, 2, more, 30), FrameOn(building));
  const AlphaImage& image = layers.at(SketchLabel("building"));
  EXPECT_EQ(image.levels[0], image.levels[1]);
  EXPECT_LT(image.levels[1], image.levels[2]);
}

// The law in the header, against io::ComposeRaster().
TEST(LabelLayersTest, AllLayersTogetherShowWhatWasSeenMost) {
  constexpr int kSeed = 20260302, kSide = 24;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  Map map = semantic_kiss_testing::EmptyMap();
  for (int i = 0; i < 12; ++i) {
    Sketch sketch(kSide, std::string(kSide, '.'));
    for (std::string& row : sketch) {
      for (char& cell : row) cell = "RSBCU......"[random() % 11];
    }
    AddSubmap(SubmapFromSketch(sketch, 1., 1 + static_cast<int>(random() % 3)),
              PlanarPose(0., 0., 0.), &map);
  }
  const RasterFrame frame{1., 0., kSide, kSide, kSide};
  const Layers layers = LayersOf(map, frame);
  const auto expected = cartographer::io::ComposeRaster(map, {}, frame);
  for (size_t i = 0; i < frame.size(); ++i) {
    Label top = kUnlabeled;
    LayerGroup top_group = LayerGroup::kGround;
    bool drawn = false;
    for (const auto& [label, image] : layers) {
      const LayerGroup group = GroupOf(map.labels, label);
      if (image.levels[i] == 0 || (drawn && group < top_group)) continue;
      top = label;
      top_group = group;
      drawn = true;
    }
    EXPECT_EQ(drawn, expected.hits[i] > 0.f);
    if (!drawn) continue;
    EXPECT_EQ(top, expected.labels[i]) << "pixel " << i;
  }
}

TEST(LabelLayersTest, GroupsFollowRoles) {
  const auto labels = SketchLabels();
  const auto group_of = [&](const char* name) { return GroupOf(labels, SketchLabel(name)); };
  EXPECT_EQ(group_of("road"), LayerGroup::kGround);
  EXPECT_EQ(group_of("building"), LayerGroup::kStanding);
  EXPECT_EQ(group_of("car"), LayerGroup::kMovable);
  EXPECT_EQ(group_of("traffic-sign"), LayerGroup::kCritical);
  EXPECT_EQ(group_of("unlabeled"), LayerGroup::kUnlabeled);
  EXPECT_STREQ(NameOf(LayerGroup::kMovable), "Movable");
}

}  // namespace
}  // namespace semantic_kiss::report
