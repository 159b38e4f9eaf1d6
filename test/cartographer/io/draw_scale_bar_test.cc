// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_scale_bar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "test/cartographer/io/decoded_png.h"

namespace cartographer::io {
namespace {

TEST(RoundLengthTest, IsOneTwoOrFive) {
  for (const auto& [length_m, expected_m] : {std::pair(1., 1.),
                                             {1.99, 1.},
                                             {2., 2.},
                                             {4.9, 2.},
                                             {5., 5.},
                                             {9.99, 5.},
                                             {10., 10.},
                                             {47., 20.},
                                             {0.3, 0.2},
                                             {0.07, 0.05},
                                             {1234., 1000.},
                                             {0.1, 0.1},
                                             {0.2, 0.2}}) {
    EXPECT_NEAR(RoundLength(length_m), expected_m, 1e-9 * expected_m) << length_m;
  }
}

TEST(RoundLengthTest, IsAtMostTheLengthAndMoreThanTwoFifths) {
  for (double length_m = 1e-4; length_m < 1e7; length_m *= 1.037) {
    const double round_m = RoundLength(length_m);
    EXPECT_LE(round_m, length_m * (1. + 1e-8));
    EXPECT_GT(round_m, 0.4 * length_m * (1. - 1e-8));
  }
}

TEST(LengthTextTest, ChoosesTheUnit) {
  EXPECT_EQ(LengthText(0.05), "5 cm");
  EXPECT_EQ(LengthText(0.1466), "14.7 cm");
  EXPECT_EQ(LengthText(1.), "1 m");
  EXPECT_EQ(LengthText(11.72), "11.7 m");
  EXPECT_EQ(LengthText(500.), "500 m");
  EXPECT_EQ(LengthText(3722.), "3.72 km");
  EXPECT_EQ(LengthText(1e8), "100000 km");
  EXPECT_EQ(LengthText(0.), "0 cm");
}

TEST(ScaleBarTest, IsAsLongAsItSays) {
  auto canvas = Canvas::Create(500, 60, {255, 255, 255});
  ASSERT_TRUE(canvas.ok());
  // 0.1 m a pixel and 230 pixels at most: 20 m are 200 pixels.
  const double width = DrawScaleBar(0.1, 230., {20., 40., 12.}, &*canvas);
  EXPECT_GT(width, 220.);
  const DecodedPng png = DecodePng(*canvas->ToPng());
  EXPECT_NE(png.At(20, 40), 0xffffffff);
  EXPECT_NE(png.At(219, 40), 0xffffffff);
  EXPECT_EQ(png.At(15, 40), 0xffffffff);
  EXPECT_EQ(png.At(225, 40), 0xffffffff);
}

TEST(AxesTest, PointRightAndUp) {
  auto canvas = Canvas::Create(80, 80, {255, 255, 255});
  ASSERT_TRUE(canvas.ok());
  EXPECT_GT(DrawAxes({20., 60., 20.}, &*canvas), 20.);
  const DecodedPng png = DecodePng(*canvas->ToPng());
  EXPECT_NE(png.At(40, 60), 0xffffffff);
  EXPECT_NE(png.At(20, 40), 0xffffffff);
  EXPECT_EQ(png.At(10, 60), 0xffffffff);
  EXPECT_EQ(png.At(20, 70), 0xffffffff);
}

}  // namespace
}  // namespace cartographer::io
