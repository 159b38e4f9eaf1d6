// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/shadow_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/map_sketch.h"

namespace semantic_kiss::report {
namespace {

using cartographer::io::RasterFrame;
using cartographer::map::Map;
using cartographer::sensor::LabelMask;
using cartographer::submap::Submap;
using semantic_kiss_testing::SketchLabel;

constexpr RasterFrame kFrame{0.25, 0., 10., 40, 40};

void AddBlock(const char* label, float x, float height, Submap* submap) {
  for (float z = 0.f; z < height; z += 0.1f) {
    for (float y = 4.f; y < 6.f; y += 0.1f) {
      submap->cloud.positions.emplace_back(x, y, z);
      submap->cloud.labels.push_back(SketchLabel(label));
      submap->cloud.certainties.push_back(1.f);
    }
  }
}

// Flat road with a wall on the left and a car on the right.
Map Street() {
  auto submap = std::make_shared<Submap>(0.25);
  for (float x = 0.f; x < 10.f; x += 0.25f) {
    for (float y = 0.f; y < 10.f; y += 0.25f) {
      submap->cloud.positions.emplace_back(x, y, 0.f);
      submap->cloud.labels.push_back(SketchLabel("road"));
      submap->cloud.certainties.push_back(1.f);
    }
  }
  AddBlock("building", 2.f, 4.f, submap.get());
  AddBlock("car", 7.f, 1.5f, submap.get());
  Map map = semantic_kiss_testing::EmptyMap();
  semantic_kiss_testing::AddSubmap(submap, semantic_kiss_testing::PlanarPose(0., 0., 0.), &map);
  return map;
}

// Of the left and of the right half of the picture.
struct Depths {
  int left = 0, right = 0;
};

Depths DepthsOf(const AlphaImage& image) {
  Depths depths;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      (column < image.width / 2 ? depths.left : depths.right) += image.Row(row)[column];
    }
  }
  return depths;
}

TEST(ShadowLayersTest, EachGroupHasItsOwnShadows) {
  const Depths standing = DepthsOf(DrawShadows(Street(), {}, LayerGroup::kStanding, kFrame));
  EXPECT_GT(standing.left, 0);
  EXPECT_EQ(standing.right, 0);
  const Depths movable = DepthsOf(DrawShadows(Street(), {}, LayerGroup::kMovable, kFrame));
  EXPECT_EQ(movable.left, 0);
  EXPECT_GT(movable.right, 0);
}

TEST(ShadowLayersTest, HiddenLabelsCastNone) {
  LabelMask hidden;
  hidden.Insert(SketchLabel("car"));
  EXPECT_TRUE(IsEmpty(DrawShadows(Street(), hidden, LayerGroup::kMovable, kFrame)));
}

TEST(ShadowLayersTest, WithoutCloudsThereAreNone) {
  const Map map = semantic_kiss_testing::MapFromSketch({"BBCC"}, 0.25);
  EXPECT_TRUE(IsEmpty(DrawShadows(map, {}, LayerGroup::kStanding, kFrame)));
}

}  // namespace
}  // namespace semantic_kiss::report
