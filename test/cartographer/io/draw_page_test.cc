// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "glog/logging.h"
#include "test/cartographer/io/decoded_png.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddNode;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::RasterFromSketch;
using semantic_kiss_testing::Sketch;

constexpr uint32_t kRed = 0xffff0000;

DecodedPng Page(const map::Map& map, const proto::RenderOptions& options,
                const SemanticRaster& raster) {
  const std::vector<uint32_t> pixels(raster.frame.size(), kRed);
  const auto canvas = DrawPage(map, options, raster, pixels);
  CHECK(canvas.ok()) << canvas.status();
  return DecodePng(*canvas->ToPng());
}

int64_t NumRed(const DecodedPng& png) {
  return std::count(png.pixels.begin(), png.pixels.end(), kRed);
}

TEST(DrawPageTest, WithoutFrameIsTheMapAlone) {
  const SemanticRaster raster = RasterFromSketch(Sketch(20, std::string(30, 'R')));
  const DecodedPng png = Page(EmptyMap(), {}, raster);
  EXPECT_EQ(png.width, 30);
  EXPECT_EQ(png.height, 20);
  EXPECT_EQ(NumRed(png), 600);
}

TEST(DrawPageTest, TheFrameCoversNothingOfTheMap) {
  proto::RenderOptions options;
  options.set_draw_frame(true);
  options.set_title("A title");
  for (const int side : {1, 20, 500}) {
    const SemanticRaster raster = RasterFromSketch(Sketch(side, std::string(2 * side, 'R')));
    const DecodedPng png = Page(EmptyMap(), options, raster);
    EXPECT_GT(png.width, 2 * side);
    EXPECT_GT(png.height, side);
    EXPECT_EQ(NumRed(png), 2 * side * side);
  }
}

TEST(DrawPageTest, GrowsForLongLegends) {
  proto::RenderOptions options;
  options.set_draw_frame(true);
  const Sketch wide(1, std::string(300, 'R'));
  const DecodedPng one = Page(EmptyMap(), options, RasterFromSketch(wide));
  const DecodedPng many = Page(EmptyMap(), options, RasterFromSketch({wide[0] + "SBCPU"}));
  EXPECT_GT(many.height, one.height + 40);
  EXPECT_GT(many.width, one.width + 5);
}

TEST(DrawPageTest, TheTitleTakesALineAndFitsWhateverItsLength) {
  const SemanticRaster raster = RasterFromSketch(Sketch(100, std::string(100, 'R')));
  proto::RenderOptions options;
  options.set_draw_frame(true);
  const DecodedPng without = Page(EmptyMap(), options, raster);
  options.set_title("Short");
  const DecodedPng with = Page(EmptyMap(), options, raster);
  options.set_title(std::string(1000, 'W') + "\xc3\x9f");
  const DecodedPng long_title = Page(EmptyMap(), options, raster);
  EXPECT_GT(with.height, without.height);
  EXPECT_EQ(long_title.width, with.width);
  EXPECT_EQ(long_title.height, with.height);
  for (int y = 0; y < long_title.height; ++y) {
    ASSERT_EQ(long_title.At(long_title.width - 1, y), 0xffffffff);
  }
}

TEST(DrawPageTest, DrawsTrajectoriesOnlyIfAsked) {
  map::Map map = EmptyMap();
  AddNode({10., 10., 0.}, &map);
  AddNode({90., 90., 0.}, &map);
  const SemanticRaster raster = RasterFromSketch(Sketch(100, std::string(100, 'R')));
  proto::RenderOptions options;
  EXPECT_EQ(NumRed(Page(map, options, raster)), 10000);
  options.set_draw_trajectory(true);
  EXPECT_LT(NumRed(Page(map, options, raster)), 9900);
}

}  // namespace
}  // namespace cartographer::io
