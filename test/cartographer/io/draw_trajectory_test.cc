// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glog/logging.h"
#include "test/cartographer/io/decoded_png.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddNode;
using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::PlanarPose;

constexpr uint32_t kGreen = 0xff00ff00;

uint32_t Pixel(sensor::Color color) {
  return 0xff000000u | color.red << 16 | color.green << 8 | color.blue;
}

// A map of 80 m x 60 m with pixels of 1 m, 10 pixels away from the canvas's edges.
const MapPlacement kPlacement{{1., 0., 60., 80, 60}, 10, 10, 2.};

template <typename Draw>
DecodedPng Drawn(const map::Map& map, const Draw& draw) {
  auto canvas = Canvas::Create(100, 80, {0, 255, 0});
  CHECK(canvas.ok());
  draw(map, kPlacement, &*canvas);
  return DecodePng(*canvas->ToPng());
}

// The pixel at a position in the map.
uint32_t At(const DecodedPng& png, double x, double y) {
  return png.At(10 + static_cast<int>(x), 10 + static_cast<int>(60. - y));
}

TEST(DrawTrajectoriesTest, ConnectsNodes) {
  map::Map map = EmptyMap();
  for (const double x : {10.5, 30.5, 60.5}) AddNode({x, 30.5, 0.}, &map);
  const DecodedPng png = Drawn(map, DrawTrajectories);
  EXPECT_EQ(At(png, 20.5, 30.5), Pixel(kTrajectoryColor));
  EXPECT_EQ(At(png, 45.5, 30.5), Pixel(kTrajectoryColor));
  EXPECT_EQ(At(png, 20.5, 40.5), kGreen);
  EXPECT_EQ(At(png, 70.5, 30.5), kGreen);
  EXPECT_EQ(At(png, 60.5, 30.5), Pixel(kTrajectoryColor)) << "a dot at the end";
  EXPECT_EQ(At(png, 10.5, 30.5), 0xffffffff) << "a ring at the start";
}

TEST(DrawTrajectoriesTest, KeepsTrajectoriesApart) {
  map::Map map = EmptyMap();
  for (int trajectory : {0, 1}) {
    for (int i = 0; i < 2; ++i) {
      map::MapNode& node = map.nodes[{trajectory, i}];
      node.map_from_node = PlanarPose(10. + 60. * i, 10. + 40. * trajectory, 0.);
    }
  }
  const DecodedPng png = Drawn(map, DrawTrajectories);
  EXPECT_EQ(At(png, 40., 10.), Pixel(kTrajectoryColor));
  EXPECT_EQ(At(png, 40., 50.), Pixel(kTrajectoryColor));
  EXPECT_EQ(At(png, 40., 30.), kGreen) << "from the end of one to the start of the other";
}

TEST(DrawTrajectoriesTest, StaysWithinTheMap) {
  map::Map map = EmptyMap();
  AddNode({-500., 30., 0.}, &map);
  AddNode({500., 30., 0.}, &map);
  const DecodedPng png = Drawn(map, DrawTrajectories);
  EXPECT_EQ(At(png, 40., 30.), Pixel(kTrajectoryColor));
  EXPECT_EQ(png.At(5, 40), kGreen);
  EXPECT_EQ(png.At(95, 40), kGreen);
}

TEST(DrawTrajectoriesTest, PassesOverNodesThatAreNotFinite) {
  map::Map map = EmptyMap();
  AddNode({std::nan(""), 0., 0.}, &map);
  AddNode({10., 30., 0.}, &map);
  AddNode({INFINITY, 0., 0.}, &map);
  AddNode({70., 30., 0.}, &map);
  EXPECT_EQ(At(Drawn(map, DrawTrajectories), 40., 30.), Pixel(kTrajectoryColor));
}

TEST(DrawTrajectoriesTest, NothingAndOneNodeAreFine) {
  map::Map map = EmptyMap();
  EXPECT_THAT(Drawn(map, DrawTrajectories).pixels, ::testing::Each(kGreen));
  AddNode({40.5, 30.5, 0.}, &map);
  EXPECT_EQ(At(Drawn(map, DrawTrajectories), 40.5, 30.5), Pixel(kTrajectoryColor));
}

TEST(DrawLoopClosuresTest, LeadFromNodesToSubmaps) {
  map::Map map = EmptyMap();
  AddNode({10., 30., 0.}, &map);
  AddSubmap(std::make_shared<submap::Submap>(0.1), PlanarPose(70., 30., 0.), &map);
  map::Constraint constraint;
  constraint.submap_id = {0, 0};
  constraint.node_id = {0, 0};
  constraint.kind = map::Constraint::Kind::kIntraSubmap;
  map.constraints = {constraint};
  EXPECT_THAT(Drawn(map, DrawLoopClosures).pixels, ::testing::Each(kGreen));
  map.constraints[0].kind = map::Constraint::Kind::kInterSubmap;
  const DecodedPng png = Drawn(map, DrawLoopClosures);
  EXPECT_NE(At(png, 40., 30.), kGreen);
  EXPECT_EQ(At(png, 40., 20.), kGreen);
}

TEST(DrawLoopClosuresTest, PassesOverWhatTheMapDoesNotHold) {
  map::Map map = EmptyMap();
  AddNode({10., 30., 0.}, &map);
  AddSubmap(std::make_shared<submap::Submap>(0.1), PlanarPose(70., 30., 0.), &map);
  map::Constraint constraint;
  constraint.kind = map::Constraint::Kind::kInterSubmap;
  constraint.submap_id = {0, 0};
  constraint.node_id = {0, 5};
  map.constraints = {constraint};
  constraint.submap_id = {3, 0};
  constraint.node_id = {0, 0};
  map.constraints.push_back(constraint);
  EXPECT_THAT(Drawn(map, DrawLoopClosures).pixels, ::testing::Each(kGreen));
}

}  // namespace
}  // namespace cartographer::io
