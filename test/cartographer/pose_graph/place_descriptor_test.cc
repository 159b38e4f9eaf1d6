// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_descriptor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/cartographer/pose_graph/place_scenes.h"

namespace cartographer::pose_graph {
namespace {

PlaceDescriptor Describe(const PlaceDescriber& describer, const sensor::LabeledPointCloud& cloud,
                         const Eigen::Vector2d& center) {
  return describer.Describe({{cloud, transform::Rigid3d()}}, center);
}

const BearingSpectrum& MiddleOf(const PlaceDescriptor& place) {
  return place.views[place.views.size() / 2];
}

double Agreement(const PlaceDescriber& describer, const BearingSpectrum& a,
                 const BearingSpectrum& b) {
  return describer.transform().FindBestHeading(a, b).score;
}

TEST(PlaceDescriptorTest, AgreesWithItselfAsOne) {
  const PlaceDescriber describer = ShippedDescriber();
  const PlaceDescriptor place = Describe(describer, Street(1), {2., 1.});
  ASSERT_EQ(place.views.size(), describer.views_per_side() * describer.views_per_side());
  EXPECT_EQ(place.center, Eigen::Vector2d(2., 1.));
  for (const BearingSpectrum& view : place.views) {
    EXPECT_NEAR(Agreement(describer, view, view), 1., 1e-4);
  }
}

TEST(PlaceDescriptorTest, ViewsAreThoseOfPlacesAroundIt) {
  const PlaceDescriber describer = ShippedDescriber();
  const sensor::LabeledPointCloud street = Street(2);
  const PlaceDescriptor place = Describe(describer, street, {0., 0.});
  const int side = describer.views_per_side();
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{{0, 0}, {1, -1}, {-2, 2}, {2, 1}}) {
    const Eigen::Vector2d center = describer.view_spacing_m() * Eigen::Vector2d(x, y);
    const PlaceDescriptor there = Describe(describer, street, center);
    const BearingSpectrum& view = place.views[(y + side / 2) * side + x + side / 2];
    // Not 1: cells lie elsewhere.
    EXPECT_GT(Agreement(describer, view, MiddleOf(there)), 0.95) << x << " " << y;
  }
}

TEST(PlaceDescriptorTest, KnowsNothingWhereNothingStands) {
  const PlaceDescriber describer = ShippedDescriber();
  EXPECT_TRUE(describer.Describe({}, {0., 0.}).empty());
  EXPECT_TRUE(Describe(describer, sensor::LabeledPointCloud(), {0., 0.}).empty());
  EXPECT_TRUE(Describe(describer, Street(1), {1000., 0.}).empty());
  // A bare road.
  const sensor::LabeledPointCloud street = Street(1);
  sensor::LabeledPointCloud road;
  for (size_t i = 0; i < street.size(); ++i) {
    if (street.labels[i] == ShippedLabels().FromName("road").value()) road.Append(street, i);
  }
  ASSERT_FALSE(road.empty());
  EXPECT_TRUE(Describe(describer, road, {0., 0.}).empty());
}

TEST(PlaceDescriptorTest, ParkedCarsChangeLittleAndAnotherStreetMuch) {
  const PlaceDescriber describer = ShippedDescriber();
  const PlaceDescriptor place = Describe(describer, Street(3), {0., 0.});
  const PlaceDescriptor other_day = Describe(describer, Street(3, 1), {0., 0.});
  const PlaceDescriptor other_street = Describe(describer, Street(4), {0., 0.});
  EXPECT_GT(Agreement(describer, MiddleOf(place), MiddleOf(other_day)), 0.98);
  EXPECT_LT(Agreement(describer, MiddleOf(place), MiddleOf(other_street)), 0.7);
}

TEST(PlaceDescriptorTest, FewPolesCountAsMuchAsManyHouses) {
  const sensor::LabelSet labels = ShippedLabels();
  const PlaceDescriber describer = ShippedDescriber();
  const auto without = [&](const sensor::LabeledPointCloud& cloud, const std::string& name) {
    sensor::LabelMask mask;
    mask.Insert(labels.FromName(name).value());
    return sensor::WithoutLabels(cloud, mask);
  };
  const sensor::LabeledPointCloud street = Street(5);
  const PlaceDescriptor place = Describe(describer, street, {0., 0.});
  const auto agreement_without = [&](const std::string& name) {
    return Agreement(describer, MiddleOf(place),
                     MiddleOf(Describe(describer, without(street, name), {0., 0.})));
  };
  // Of four equal channels, three are left: sqrt(3 / 4).
  EXPECT_NEAR(agreement_without("pole"), std::sqrt(0.75), 1e-3);
  EXPECT_NEAR(agreement_without("building"), std::sqrt(0.75), 1e-3);
}

}  // namespace
}  // namespace cartographer::pose_graph
