// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_shadow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "test/cartographer/io/on_threads.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::SketchLabel;
using ::testing::Each;

const RasterFrame kFrame{0.1, 0., 20., 200, 200};

void AddPoint(const std::string& label, const Eigen::Vector3f& position, submap::Submap* submap) {
  submap->cloud.positions.push_back(position);
  submap->cloud.labels.push_back(SketchLabel(label));
  submap->cloud.certainties.push_back(1.f);
}

// Flat road with a wall of height 4 m along x, at x from 5 to 15, y = 10, standing on it.
map::Map WallOnARoad(const std::string& wall_label) {
  auto submap = std::make_shared<submap::Submap>(0.1);
  for (float x = 0.5f; x < 20.f; x += 1.f) {
    for (float y = 0.5f; y < 20.f; y += 1.f) AddPoint("road", {x, y, -2.f}, submap.get());
  }
  for (float x = 5.f; x < 15.f; x += 0.2f) {
    for (float z = -2.f; z < 2.f; z += 0.2f) AddPoint(wall_label, {x, 10.f, z}, submap.get());
  }
  map::Map map = EmptyMap();
  AddSubmap(submap, transform::Rigid3d(), &map);
  return map;
}

float At(const std::vector<float>& shadow, double x, double y) {
  const Eigen::Vector2d pixel = kFrame.PixelFromMap({x, y});
  return shadow[static_cast<size_t>(pixel.y()) * kFrame.width + static_cast<size_t>(pixel.x())];
}

TEST(CastShadowsTest, FallToTheLowerRight) {
  const std::vector<float> shadow = CastShadows(WallOnARoad("building"), {}, kFrame);
  EXPECT_GT(At(shadow, 10., 9.5), 0.5f);
  EXPECT_EQ(At(shadow, 10., 10.6), 0.f) << "above the wall";
  EXPECT_EQ(At(shadow, 10., 8.), 0.f) << "beyond the shadow of a 4 m wall";
  EXPECT_EQ(At(shadow, 4.2, 9.5), 0.f) << "left of the wall";
  EXPECT_EQ(At(shadow, 17., 9.5), 0.f) << "right of the shadow";
  EXPECT_GE(*std::min_element(shadow.begin(), shadow.end()), 0.f);
  EXPECT_LE(*std::max_element(shadow.begin(), shadow.end()), 1.f);
}

TEST(CastShadowsTest, GroundUnlabeledAndHiddenPointsCastNone) {
  EXPECT_THAT(CastShadows(WallOnARoad("sidewalk"), {}, kFrame), Each(0.f));
  EXPECT_THAT(CastShadows(WallOnARoad("unlabeled"), {}, kFrame), Each(0.f));
  sensor::LabelMask hidden;
  hidden.Insert(SketchLabel("building"));
  EXPECT_THAT(CastShadows(WallOnARoad("building"), hidden, kFrame), Each(0.f));
}

TEST(CastShadowsTest, WithoutGroundThereIsNoHeightAndNoShadow) {
  auto submap = std::make_shared<submap::Submap>(0.1);
  for (int i = 0; i < 1000; ++i) AddPoint("building", {10.f, 10.f, 0.01f * i}, submap.get());
  map::Map map = EmptyMap();
  AddSubmap(submap, transform::Rigid3d(), &map);
  EXPECT_THAT(CastShadows(map, {}, kFrame), Each(0.f));
}

TEST(CastShadowsTest, LonePointsCastNone) {
  auto submap = std::make_shared<submap::Submap>(0.1);
  AddPoint("road", {10.f, 10.f, 0.f}, submap.get());
  AddPoint("building", {10.f, 10.f, 3.f}, submap.get());
  map::Map map = EmptyMap();
  AddSubmap(submap, transform::Rigid3d(), &map);
  const std::vector<float> shadow = CastShadows(map, {}, kFrame);
  EXPECT_LT(*std::max_element(shadow.begin(), shadow.end()), 0.05f);
}

TEST(CastShadowsTest, ThreadsDoNotShow) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.f, 20.f);
  map::Map map = EmptyMap();
  for (int i = 0; i < 20; ++i) {
    auto submap = std::make_shared<submap::Submap>(0.1);
    for (int j = 0; j < 500; ++j) {
      AddPoint("road", {uniform(random), uniform(random), 0.01f * uniform(random)}, submap.get());
      AddPoint("building", {uniform(random), uniform(random), uniform(random)}, submap.get());
    }
    AddSubmap(submap, transform::Rigid3d(), &map);
  }
  const auto one = OnThreads(1, [&] { return CastShadows(map, {}, kFrame); });
  const auto four = OnThreads(4, [&] { return CastShadows(map, {}, kFrame); });
  EXPECT_EQ(one, four);
}

}  // namespace
}  // namespace cartographer::io
