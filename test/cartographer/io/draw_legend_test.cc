// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_legend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cartographer/io/raster_shading.h"
#include "test/cartographer/io/decoded_png.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::RasterFromSketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SketchLabels;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> TextsOf(const SemanticRaster& raster) {
  std::vector<std::string> texts;
  for (const LegendEntry& entry : LegendOf(raster, SketchLabels())) texts.push_back(entry.text);
  return texts;
}

TEST(LegendTest, ListsWhatIsThereByArea) {
  EXPECT_THAT(TextsOf(RasterFromSketch({"UUUUUU", "BBBRRC", "S.P..."})),
              ElementsAre("building", "road", "sidewalk", "car", "traffic sign", "unlabeled"));
  EXPECT_THAT(TextsOf(RasterFromSketch({"..C.."})), ElementsAre("car"));
  EXPECT_THAT(TextsOf(RasterFromSketch({"....."})), IsEmpty());
}

TEST(LegendTest, CountsFilledGaps) {
  SemanticRaster raster = RasterFromSketch({"BBSSS"});
  raster.hits = {1.f, 1.f, 1.f, 0.f, 0.f};
  EXPECT_THAT(TextsOf(raster), ElementsAre("sidewalk", "building"));
}

TEST(LegendTest, ShowsTheColorsOfThePicture) {
  const auto entries = LegendOf(RasterFromSketch({"RPU"}), SketchLabels());
  ASSERT_EQ(entries.size(), 3);
  const sensor::Color road = BaseColor(SketchLabels(), SketchLabel("road"));
  EXPECT_EQ(entries[0].color.red, road.red);
  EXPECT_EQ(entries[0].sample, LegendEntry::Sample::kArea);
  EXPECT_EQ(entries[1].sample, LegendEntry::Sample::kMark);
  EXPECT_EQ(entries[2].color.red, UnlabeledColor(true).red);
  EXPECT_EQ(LegendOf(RasterFromSketch({"U"}), SketchLabels())[0].color.red,
            UnlabeledColor(false).red);
}

TEST(LegendTest, IsDrawnWithinItsSize) {
  const std::vector<LegendEntry> entries{
      {LegendEntry::Sample::kArea, {1, 2, 3}, "road"},
      {LegendEntry::Sample::kMark, {200, 0, 0}, "a rather long name of a label"},
      {LegendEntry::Sample::kLine, {0, 0, 0}, "trajectory"},
      {LegendEntry::Sample::kStart, {0, 0, 0}, "start"},
      {LegendEntry::Sample::kEnd, {0, 0, 0}, "end"}};
  auto canvas = Canvas::Create(600, 300, {255, 255, 255});
  ASSERT_TRUE(canvas.ok());
  const LegendSize size = MeasureLegend(entries, 20., &*canvas);
  DrawLegend(entries, 20., 50., 40., &*canvas);
  const DecodedPng png = DecodePng(*canvas->ToPng());
  EXPECT_EQ(png.At(60, 56), 0xff010203);
  for (int y = 0; y < png.height; ++y) {
    for (int x = 0; x < png.width; ++x) {
      if (png.At(x, y) == 0xffffffff) continue;
      ASSERT_TRUE(x >= 48 && x <= 52 + size.width_px) << x;
      ASSERT_TRUE(y >= 40 && y <= 40 + size.height_px) << y;
    }
  }
  EXPECT_EQ(MeasureLegend({}, 20., &*canvas).height_px, 0.);
}

}  // namespace
}  // namespace cartographer::io
