// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "glog/logging.h"

namespace cartographer::map {
namespace {

using ::testing::HasSubstr;

proto::FilterOptions PolygonOptions(const std::vector<double>& numbers) {
  proto::FilterOptions options;
  for (const double number : numbers) options.add_polygon(number);
  return options;
}

proto::FilterOptions BoxOptions(const std::vector<double>& numbers) {
  proto::FilterOptions options;
  for (const double number : numbers) options.add_box(number);
  return options;
}

Region Make(const proto::FilterOptions& options) {
  const auto region = Region::Create(options);
  CHECK(region.ok()) << region.status();
  return *region;
}

std::string Error(const proto::FilterOptions& options) {
  return std::string(Region::Create(options).status().message());
}

TEST(RegionTest, WithoutCornersItIsEverywhere) {
  const Region region = Make({});
  EXPECT_TRUE(region.IsEverywhere());
  EXPECT_TRUE(region.Contains({1e9, -1e9}));
}

TEST(RegionTest, BoxesSideBySideShareNoPointAndMissNone) {
  const Region left = Make(BoxOptions({-1., 0., 2., 4.})),
               right = Make(BoxOptions({2., 0., 3., 4.}));
  for (double y = -0.5; y < 5.; y += 0.5) {
    for (double x = -1.5; x < 4.; x += 0.5) {
      const bool inside = x >= -1. && x < 3. && y >= 0. && y < 4.;
      EXPECT_EQ(left.Contains({x, y}) + right.Contains({x, y}), inside ? 1 : 0) << x << " " << y;
    }
  }
}

TEST(RegionTest, OutsideIsTheRest) {
  proto::FilterOptions options = PolygonOptions({0., 0., 4., 0., 2., 3.});
  const Region inside = Make(options);
  options.set_outside(true);
  const Region outside = Make(options);
  for (double y = -1.; y < 4.; y += 0.25) {
    for (double x = -1.; x < 5.; x += 0.25) {
      EXPECT_NE(inside.Contains({x, y}), outside.Contains({x, y})) << x << " " << y;
    }
  }
}

// A point is in a triangle if it is on one side of all its edges.
TEST(RegionTest, TrianglesAgreeWithTheirEdges) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-10., 10.);
  const auto point = [&] { return Eigen::Vector2d(uniform(random), uniform(random)); };
  int num_inside = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d corners[] = {point(), point(), point()};
    const Region region = Make(PolygonOptions({corners[0].x(), corners[0].y(), corners[1].x(),
                                               corners[1].y(), corners[2].x(), corners[2].y()}));
    for (int j = 0; j < 50; ++j) {
      const Eigen::Vector2d p = point();
      int left = 0;
      for (int edge = 0; edge < 3; ++edge) {
        const Eigen::Vector2d along = corners[(edge + 1) % 3] - corners[edge];
        const Eigen::Vector2d to = p - corners[edge];
        left += along.x() * to.y() - along.y() * to.x() > 0. ? 1 : 0;
      }
      EXPECT_EQ(region.Contains(p), left == 0 || left == 3) << i << " " << p.transpose();
      num_inside += region.Contains(p);
    }
  }
  EXPECT_GT(num_inside, 1000);
}

TEST(RegionTest, NotchesAndHolesAreOutside) {
  // A horseshoe, open to the right.
  const Region horseshoe = Make(PolygonOptions({0, 0, 6, 0, 6, 2, 2, 2, 2, 4, 6, 4, 6, 6, 0, 6}));
  EXPECT_TRUE(horseshoe.Contains({1., 3.}));
  EXPECT_TRUE(horseshoe.Contains({5., 1.}));
  EXPECT_FALSE(horseshoe.Contains({5., 3.}));
  // A five-pointed star, whose middle is enclosed twice.
  std::vector<double> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2. * M_PI * 2. * i / 5.;
    star.push_back(std::cos(angle)), star.push_back(std::sin(angle));
  }
  EXPECT_TRUE(Make(PolygonOptions(star)).Contains({0.8, 0.}));
  EXPECT_FALSE(Make(PolygonOptions(star)).Contains({0., 0.}));
}

TEST(RegionTest, ErrorsNameOptionAndRemedy) {
  EXPECT_EQ(Error(PolygonOptions({1, 2, 3, 4, 5})),
            "polygon: has 5 numbers, the last corner lacks its y; give x1,y1,x2,y2,...");
  EXPECT_EQ(Error(PolygonOptions({1, 2, 3, 4})),
            "polygon: has 2 corners; give at least 3, as x1,y1,x2,y2,x3,y3");
  EXPECT_EQ(Error(PolygonOptions({1, 2, 3, std::nan(""), 5, 6})),
            "polygon: number 4 is nan; give metres");
  EXPECT_EQ(Error(BoxOptions({1, 2, 3})), "box: has 3 numbers; give 4, x_min,y_min,x_max,y_max");
  EXPECT_EQ(Error(BoxOptions({1, 2, 1, 4})),
            "box: from (1, 2) to (1, 4) has no area; give x_min,y_min,x_max,y_max");
  EXPECT_THAT(Error(BoxOptions({1, 2, std::numeric_limits<double>::infinity(), 4})),
              HasSubstr("box: number 3 is inf"));
  proto::FilterOptions both = BoxOptions({0, 0, 1, 1});
  both.add_polygon(1.);
  EXPECT_EQ(Error(both), "polygon: there is a box as well; give one of the two");
  proto::FilterOptions outside;
  outside.set_outside(true);
  EXPECT_EQ(Error(outside), "outside: of what? give a polygon or a box as well");
}

}  // namespace
}  // namespace cartographer::map
