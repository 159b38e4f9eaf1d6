// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_shading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/cartographer/io/on_threads.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::RasterFromSketch;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SketchLabels;

uint32_t Pixel(sensor::Color color) {
  return 0xff000000u | color.red << 16 | color.green << 8 | color.blue;
}

int Brightness(uint32_t pixel) { return (pixel >> 16 & 255) + (pixel >> 8 & 255) + (pixel & 255); }

std::vector<uint32_t> Shade(const SemanticRaster& raster, float shadow = 0.f) {
  return ShadeRaster(raster, SketchLabels(), std::vector<float>(raster.frame.size(), shadow));
}

TEST(ShadeRasterTest, PaintsTheLabelsColors) {
  const auto pixels = Shade(RasterFromSketch({"RSBC."}));
  const auto base = [](const char* name) { return BaseColor(SketchLabels(), SketchLabel(name)); };
  EXPECT_EQ(pixels[0], Pixel(base("road")));
  EXPECT_EQ(pixels[1], Pixel(base("sidewalk")));
  EXPECT_EQ(pixels[4], Pixel(kBackgroundColor));
  // Objects are close to their own color at their usual number of hits.
  const auto far_off = [](uint32_t pixel, sensor::Color color) {
    return std::abs(int(pixel >> 16 & 255) - color.red) +
           std::abs(int(pixel >> 8 & 255) - color.green) + std::abs(int(pixel & 255) - color.blue);
  };
  EXPECT_LT(far_off(pixels[2], base("building")), 120);
  EXPECT_LT(far_off(pixels[3], base("car")), 120);
}

TEST(ShadeRasterTest, GroundIsEvenWhateverItsHits) {
  SemanticRaster raster = RasterFromSketch({"RRRR"});
  raster.hits = {1.f, 10.f, 1000.f, 0.01f};
  const auto pixels = Shade(raster);
  EXPECT_THAT(pixels, ::testing::Each(pixels[0]));
}

TEST(ShadeRasterTest, FilledGapsArePalerThanSeenGround) {
  SemanticRaster raster = RasterFromSketch({"SS"});
  raster.hits[1] = 0.f;
  const auto pixels = Shade(raster);
  EXPECT_GT(Brightness(pixels[1]), Brightness(pixels[0]));
  EXPECT_LT(Brightness(pixels[1]), Brightness(Pixel(kBackgroundColor)));
}

TEST(ShadeRasterTest, ObjectsDarkenWithHits) {
  SemanticRaster raster = RasterFromSketch({"BBBBB"});
  raster.hits = {1.f, 4.f, 16.f, 64.f, 256.f};
  const auto pixels = Shade(raster);
  for (int i = 1; i < 5; ++i) EXPECT_LT(Brightness(pixels[i]), Brightness(pixels[i - 1])) << i;
}

TEST(ShadeRasterTest, HitsAreJudgedByTheLabelsMedian) {
  SemanticRaster few = RasterFromSketch({"BBB"}), many = few;
  few.hits = {1.f, 2.f, 4.f};
  many.hits = {1024.f, 2048.f, 4096.f};
  EXPECT_EQ(Shade(few), Shade(many));
}

TEST(ShadeRasterTest, UnlabeledIsFaintBesideLabelsOnly) {
  const uint32_t alone = Shade(RasterFromSketch({"UU"}))[0];
  const uint32_t beside = Shade(RasterFromSketch({"UR"}))[0];
  EXPECT_LT(Brightness(alone), Brightness(beside) - 200);
  EXPECT_LT(Brightness(beside), Brightness(Pixel(kBackgroundColor)));
}

TEST(ShadeRasterTest, CriticalLabelsGetAMarkWithARim) {
  const auto pixels = Shade(RasterFromSketch(
      {".......", ".......", ".......", "...P...", ".......", ".......", "......."}));
  const uint32_t core = Pixel(SketchLabels().ColorOf(SketchLabel("traffic-sign")));
  const auto at = [&](int x, int y) { return pixels[y * 7 + x]; };
  EXPECT_EQ(at(3, 3), core);
  EXPECT_EQ(at(4, 3), core);
  EXPECT_EQ(at(3, 2), core);
  EXPECT_EQ(at(5, 3), Pixel(kRimColor));
  EXPECT_EQ(at(3, 1), Pixel(kRimColor));
  EXPECT_EQ(at(6, 3), Pixel(kBackgroundColor));
}

TEST(ShadeRasterTest, MarksAtTheEdgeStayInside) {
  const auto pixels = Shade(RasterFromSketch({"P.", ".P"}));
  EXPECT_EQ(pixels.size(), 4);
}

TEST(ShadeRasterTest, ShadowsDarkenGroundAndBackground) {
  const SemanticRaster raster = RasterFromSketch({"R.B"});
  const auto lit = Shade(raster), dark = Shade(raster, 1.f);
  EXPECT_LT(Brightness(dark[0]), Brightness(lit[0]) - 50);
  EXPECT_LT(Brightness(dark[1]), Brightness(lit[1]) - 100);
  EXPECT_NEAR(Brightness(dark[2]), Brightness(lit[2]), 60);
}

TEST(ShadeRasterTest, ThreadsDoNotShow) {
  SemanticRaster raster = RasterFromSketch(Sketch(100, "RSBC.UPRSBC.U..BBB"));
  for (size_t i = 0; i < raster.hits.size(); ++i) raster.hits[i] *= 1.f + i % 97;
  const auto one = OnThreads(1, [&] { return Shade(raster, 0.5f); });
  const auto four = OnThreads(4, [&] { return Shade(raster, 0.5f); });
  EXPECT_EQ(one, four);
}

}  // namespace
}  // namespace cartographer::io
