// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_canvas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "glog/logging.h"
#include "test/cartographer/io/decoded_png.h"

namespace cartographer::io {
namespace {

using ::testing::HasSubstr;

constexpr sensor::Color kWhite{255, 255, 255};
constexpr uint32_t kWhitePixel = 0xffffffff;

Canvas MakeCanvas(int width, int height) {
  auto canvas = Canvas::Create(width, height, kWhite);
  CHECK(canvas.ok()) << canvas.status();
  return *std::move(canvas);
}

DecodedPng Decoded(const Canvas& canvas) {
  const auto bytes = canvas.ToPng();
  CHECK(bytes.ok()) << bytes.status();
  return DecodePng(*bytes);
}

int NumInked(const DecodedPng& png) {
  return png.pixels.size() - std::count(png.pixels.begin(), png.pixels.end(), kWhitePixel);
}

TEST(CanvasTest, StartsInOneColor) {
  const auto canvas = Canvas::Create(3, 2, {10, 20, 30});
  ASSERT_TRUE(canvas.ok());
  const DecodedPng png = Decoded(*canvas);
  EXPECT_EQ(png.width, 3);
  EXPECT_EQ(png.height, 2);
  EXPECT_THAT(png.pixels, ::testing::Each(0xff0a141e));
}

TEST(CanvasTest, WritesPngFiles) {
  EXPECT_EQ(MakeCanvas(1, 1).ToPng()->substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST(CanvasTest, SizesBeyondCairosAreAnError) {
  const auto canvas = Canvas::Create(40000, 10, kWhite);
  EXPECT_EQ(canvas.status().code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(canvas.status().message()),
              HasSubstr("cannot make a picture of 40000 x 10 pixels"));
}

TEST(CanvasTest, PutsPixelsInTheirPlace) {
  Canvas canvas = MakeCanvas(4, 3);
  canvas.DrawPixels({0xff000001, 0xff000002, 0xff000003, 0xff000004}, 2, 1, 1);
  const DecodedPng png = Decoded(canvas);
  EXPECT_EQ(png.pixels,
            (std::vector<uint32_t>{kWhitePixel, kWhitePixel, kWhitePixel, kWhitePixel,  //
                                   kWhitePixel, 0xff000001, 0xff000002, kWhitePixel,    //
                                   kWhitePixel, 0xff000003, 0xff000004, kWhitePixel}));
}

TEST(CanvasDeathTest, PixelsMustFit) {
  Canvas canvas = MakeCanvas(4, 3);
  EXPECT_DEATH(canvas.DrawPixels({1, 2, 3, 4}, 2, 3, 0), "");
  EXPECT_DEATH(canvas.DrawPixels({1, 2, 3}, 2, 0, 0), "");
}

TEST(CanvasTest, WritesText) {
  Canvas canvas = MakeCanvas(200, 40);
  const TextStyle style{20., false, {0, 0, 0}};
  EXPECT_EQ(canvas.TextWidth("", style), 0.);
  EXPECT_GT(canvas.TextWidth("sidewalk", style), canvas.TextWidth("road", style));
  EXPECT_NEAR(canvas.TextWidth("road", {40., false, {}}), 2. * canvas.TextWidth("road", style), 2.);
  canvas.DrawText("road", 5., 30., style);
  EXPECT_GT(NumInked(Decoded(canvas)), 50);
}

TEST(CanvasTest, TextThatIsNotUtf8DoesNotSpoilTheDrawing) {
  Canvas canvas = MakeCanvas(200, 40);
  const TextStyle style{20., false, {0, 0, 0}};
  for (const char* const text : {"caf\xe9", "\xff\xfe", "\xf0\x9f",
                                 "stra\xc3\x9f"
                                 "e",
                                 "a\nb\tc"}) {
    canvas.DrawText(text, 5., 30., style);
    EXPECT_GE(canvas.TextWidth(text, style), 0.);
    EXPECT_TRUE(canvas.ToPng().ok()) << text;
  }
  EXPECT_EQ(canvas.TextWidth("caf\xe9", style), canvas.TextWidth("caf?", style));
  EXPECT_GT(NumInked(Decoded(canvas)), 50);
}

TEST(CanvasTest, TheSameDrawingHasTheSameBytes) {
  const auto draw = [] {
    Canvas canvas = MakeCanvas(100, 30);
    canvas.DrawText("same", 3., 20., {15., true, {200, 0, 0}});
    return *canvas.ToPng();
  };
  EXPECT_EQ(draw(), draw());
}

}  // namespace
}  // namespace cartographer::io
