// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/alpha_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/semantic_kiss/report/decoded_png.h"

namespace semantic_kiss::report {
namespace {

using semantic_kiss_testing::DecodedPng;
using semantic_kiss_testing::DecodePng;
using ::testing::ElementsAre;

AlphaImage ImageOf(int width, std::vector<uint8_t> levels) {
  AlphaImage image(width, static_cast<int>(levels.size()) / width);
  image.levels = std::move(levels);
  return image;
}

TEST(AlphaImageTest, OtherReadersSeeColorAndOpacity) {
  // An odd width: the last byte of each row is half used.
  const DecodedPng png = DecodePng(ToPng(ImageOf(3, {0, 5, kOpaque, 10, 0, 1}), {{255, 0, 51}}));
  EXPECT_EQ(png.width, 3);
  EXPECT_EQ(png.height, 2);
  EXPECT_THAT(png.pixels, ElementsAre(0u, 0x55550011u, 0xffff0033u, 0xaaaa0022u, 0u, 0x11110003u));
}

TEST(AlphaImageTest, APixelIsAnImage) {
  EXPECT_THAT(DecodePng(ToPng(ImageOf(1, {kOpaque}), {{1, 2, 3}})).pixels,
              ElementsAre(0xff010203u));
}

TEST(AlphaImageTest, InkMayBeThin) {
  EXPECT_THAT(DecodePng(ToPng(ImageOf(2, {kOpaque, 5}), {{255, 255, 255}, 0.4})).pixels,
              ElementsAre(0x66666666u, 0x22222222u));
}

TEST(AlphaImageTest, NothingIsNoImage) { EXPECT_DEATH(ToPng(AlphaImage(), {}), "width"); }

TEST(AlphaImageTest, CutsOutSquares) {
  const AlphaImage image = ImageOf(3, {1, 2, 3,  //
                                       4, 5, 6});
  EXPECT_THAT(CutOut(image, 1, 0, 2).levels, ElementsAre(2, 3, 5, 6));
  EXPECT_THAT(CutOut(image, 2, 1, 2).levels, ElementsAre(6, 0, 0, 0));
  EXPECT_TRUE(IsEmpty(CutOut(image, 4, 0, 2)));
  EXPECT_TRUE(IsEmpty(CutOut(image, 0, 4, 2)));
}

TEST(AlphaImageTest, HalvesKeepAreasAndSparePoints) {
  EXPECT_THAT(Halved(ImageOf(2, {8, 8, 8, 8})).levels, ElementsAre(8));
  EXPECT_THAT(Halved(ImageOf(2, {0, 0, 0, 0})).levels, ElementsAre(0));
  // The mean is 4, the strongest 15.
  EXPECT_THAT(Halved(ImageOf(2, {15, 0, 0, 0})).levels, ElementsAre(9));
  // What lies beyond the edge counts as empty.
  const AlphaImage odd = Halved(ImageOf(3, {12, 12, 12}));
  EXPECT_EQ(odd.width, 2);
  EXPECT_EQ(odd.height, 1);
  EXPECT_THAT(odd.levels, ElementsAre(9, 8));
}

TEST(AlphaImageTest, APointOutlastsManyHalvings) {
  AlphaImage image(64, 64);
  image.Row(37)[21] = kOpaque;
  for (int i = 0; i < 4; ++i) image = Halved(image);
  EXPECT_FALSE(IsEmpty(image));
}

}  // namespace
}  // namespace semantic_kiss::report
