// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

#include "test/semantic_kiss/report/decoded_png.h"
#include "test/testing/map_sketch.h"

namespace semantic_kiss::live {
namespace {

using cartographer::submap::SubmapId;
using cartographer::transform::Rigid3d;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SketchLabels;
using semantic_kiss_testing::SubmapFromSketch;

void Add(int index, const Sketch& sketch, const Rigid3d& pose, int hits, Snapshot* snapshot) {
  snapshot->submaps[SubmapId{0, index}] = {pose, SubmapFromSketch(sketch, 0.4, hits)};
}

// The red of the picture at a place of the map; -1 where it is transparent.
int RedAt(const Picture& picture, double x, double y) {
  const semantic_kiss_testing::DecodedPng png = semantic_kiss_testing::DecodePng(picture.Png());
  const Eigen::Vector2d at = picture.frame().PixelFromMap({x, y});
  const uint32_t pixel =
      png.pixels[static_cast<size_t>(at.y()) * png.width + static_cast<size_t>(at.x())];
  return pixel >> 24 == 0 ? -1 : static_cast<int>(pixel >> 16 & 0xff);
}

int RedOf(const std::string& label) { return SketchLabels().ColorOf(SketchLabel(label)).red; }

TEST(PictureTest, IsEmptyBeforeAnythingIsDrawn) {
  Picture picture(SketchLabels());
  EXPECT_FALSE(picture.Draw({}));
  EXPECT_EQ(picture.Png(), "");
  EXPECT_EQ(picture.frame().size(), 0u);
}

TEST(PictureTest, ShowsWhatWasSeenMostOften) {
  Picture picture(SketchLabels());
  Snapshot snapshot;
  Add(0, {"RR.B"}, Rigid3d(), 2, &snapshot);
  EXPECT_TRUE(picture.Draw(snapshot));
  EXPECT_FALSE(picture.Draw(snapshot));  // nothing new
  EXPECT_EQ(RedAt(picture, 0.2, 0.2), RedOf("road"));
  EXPECT_EQ(RedAt(picture, 1.0, 0.2), -1);
  EXPECT_EQ(RedAt(picture, 1.4, 0.2), RedOf("building"));

  Add(1, {"BBBB"}, Rigid3d(), 1, &snapshot);  // seen less often
  EXPECT_TRUE(picture.Draw(snapshot));
  EXPECT_EQ(RedAt(picture, 0.2, 0.2), RedOf("road"));
  EXPECT_EQ(RedAt(picture, 1.0, 0.2), RedOf("building"));
}

TEST(PictureTest, AnyLabelBeatsNone) {
  Picture picture(SketchLabels());
  Snapshot snapshot;
  Add(0, {"U"}, Rigid3d(), 50, &snapshot);
  Add(1, {"R"}, Rigid3d(), 1, &snapshot);
  Add(2, {"U"}, Rigid3d(), 50, &snapshot);
  picture.Draw(snapshot);
  EXPECT_EQ(RedAt(picture, 0.2, 0.2), RedOf("road"));
}

TEST(PictureTest, GrowsWithoutLosingAnything) {
  Picture picture(SketchLabels());
  Snapshot snapshot;
  for (int i = 0; i < 40; ++i) {  // over 3 km: pixels become larger on the way
    Add(i, {"RR", "RR"}, Rigid3d::Translation({100. * i, -50. * i, 0.}), 1, &snapshot);
    EXPECT_TRUE(picture.Draw(snapshot));
  }
  EXPECT_LE(picture.frame().width, 2400);
  EXPECT_GT(picture.frame().resolution_m, 0.4);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(RedAt(picture, 100. * i + 0.2, -50. * i + 0.2), RedOf("road")) << i;
  }
}

TEST(PictureTest, FollowsWhatLoopClosuresMove) {
  Picture picture(SketchLabels());
  Snapshot snapshot;
  Add(0, {"R"}, Rigid3d(), 1, &snapshot);
  Add(1, {"B"}, PlanarPose(20., 0., 0.), 1, &snapshot);
  picture.Draw(snapshot);
  snapshot.submaps[SubmapId{0, 1}].map_from_submap = PlanarPose(20., 8., 0.);
  EXPECT_TRUE(picture.Draw(snapshot));
  EXPECT_EQ(RedAt(picture, 0.2, 0.2), RedOf("road"));
  EXPECT_EQ(RedAt(picture, 20.2, 0.2), -1);
  EXPECT_EQ(RedAt(picture, 20.2, 8.2), RedOf("building"));
  // Less than a pixel is not worth it.
  snapshot.submaps[SubmapId{0, 1}].map_from_submap = PlanarPose(20., 8.1, 0.);
  EXPECT_FALSE(picture.Draw(snapshot));
}

TEST(PictureTest, SurvivesPosesThatAreNone) {
  Picture picture(SketchLabels());
  Snapshot snapshot;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Add(0, {"R"}, Rigid3d::Translation({nan, 0., 0.}), 1, &snapshot);
  EXPECT_FALSE(picture.Draw(snapshot));
}

}  // namespace
}  // namespace semantic_kiss::live
