// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/ground_height.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::SketchLabel;

const RasterFrame kFrame{0.1, 0., 20., 200, 200};

// A map whose one cloud holds points of a label.
map::Map MapOfPoints(const std::string& label, const std::vector<Eigen::Vector3f>& positions) {
  map::Map map = EmptyMap();
  auto submap = std::make_shared<submap::Submap>(0.1);
  for (const Eigen::Vector3f& position : positions) {
    submap->cloud.positions.push_back(position);
    submap->cloud.labels.push_back(SketchLabel(label));
    submap->cloud.certainties.push_back(1.f);
  }
  AddSubmap(submap, transform::Rigid3d(), &map);
  return map;
}

TEST(GroundHeightTest, IsUnknownWithoutGroundPoints) {
  EXPECT_FALSE(GroundHeight(EmptyMap(), kFrame).known());
  const GroundHeight ground(MapOfPoints("building", {{1.f, 1.f, 7.f}}), kFrame);
  EXPECT_FALSE(ground.known());
  EXPECT_EQ(ground.At(1., 1.), 0.f);
}

TEST(GroundHeightTest, IsTheMeanWithinAMetre) {
  const GroundHeight ground(
      MapOfPoints("road", {{1.1f, 1.1f, 1.f}, {1.9f, 1.8f, 2.f}, {5.5f, 5.5f, -4.f}}), kFrame);
  EXPECT_TRUE(ground.known());
  EXPECT_NEAR(ground.At(1.5, 1.5), 1.5f, 1e-3);
  EXPECT_NEAR(ground.At(5.1, 5.9), -4.f, 1e-3);
}

TEST(GroundHeightTest, SpreadsToWhereNothingWasSeen) {
  const GroundHeight ground(MapOfPoints("road", {{2.5f, 2.5f, 3.f}, {17.5f, 17.5f, 9.f}}), kFrame);
  EXPECT_NEAR(ground.At(1.5, 1.5), 3.f, 1e-3);
  EXPECT_NEAR(ground.At(18.5, 18.5), 9.f, 1e-3);
  for (double x = -50.; x < 70.; x += 0.7) {
    for (double y = -50.; y < 70.; y += 0.7) {
      EXPECT_GE(ground.At(x, y), 3.f - 1e-3f);
      EXPECT_LE(ground.At(x, y), 9.f + 1e-3f);
    }
  }
}

TEST(GroundHeightTest, FollowsPosesInSpace) {
  map::Map map = MapOfPoints("road", {{0.5f, 0.5f, 1.f}});
  map.submaps.begin()->second.map_from_submap =
      transform::Rigid3d::Translation(Eigen::Vector3d(10., 10., 100.));
  EXPECT_NEAR(GroundHeight(map, kFrame).At(10.5, 10.5), 101.f, 1e-3);
}

TEST(GroundHeightTest, PassesOverWhatIsNotFinite) {
  const float nan = std::nanf(""), infinity = INFINITY;
  const GroundHeight ground(MapOfPoints("road", {{nan, 1.f, 1.f},
                                                 {1.f, infinity, 1.f},
                                                 {1.f, 1.f, nan},
                                                 {1.f, 1.f, 1e30f},
                                                 {1e30f, 1.f, 1.f},
                                                 {1.5f, 1.5f, 2.f}}),
                            kFrame);
  EXPECT_NEAR(ground.At(1.5, 1.5), 2.f, 1e-3);
}

}  // namespace
}  // namespace cartographer::io
