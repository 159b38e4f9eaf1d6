// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tbb/global_control.h"
#include "test/cartographer/pose_graph/place_scenes.h"

namespace cartographer::pose_graph {
namespace {

constexpr int kNumStreets = 12;
constexpr double kDegree = M_PI / 180.;

PlaceDescriptor DescribeStreet(const PlaceDescriber& describer, int seed,
                               const transform::Rigid3d& frame_from_street) {
  const sensor::LabeledPointCloud cloud = Street(seed);
  return describer.Describe({{cloud, frame_from_street}},
                            frame_from_street.translation().head<2>());
}

PlaceIndex IndexOfStreets(const PlaceDescriber& describer) {
  PlaceIndex index(describer);
  for (int i = 0; i < kNumStreets; ++i) {
    index.Add({0, i}, DescribeStreet(describer, i, transform::Rigid3d()));
  }
  return index;
}

TEST(PlaceIndexTest, FindsTheStreetAtAnyHeading) {
  const PlaceDescriber describer = ShippedDescriber();
  const PlaceIndex index = IndexOfStreets(describer);
  for (int i = 0; i < kNumStreets; ++i) {
    const double yaw = (37. * i + 5.) * kDegree;
    const transform::Rigid3d query_from_street = InPlane(3., -2., yaw);
    const auto found = index.Find(DescribeStreet(describer, i, query_from_street), 3, nullptr);
    ASSERT_EQ(found.size(), 3);
    EXPECT_EQ(found[0].submap_id, (submap::SubmapId{0, i}));
    EXPECT_GT(found[0].score, 0.9);
    EXPECT_GT(found[0].score, found[1].score);
    const transform::Rigid3d truth = query_from_street.inverse();
    EXPECT_NEAR(std::remainder(found[0].submap_from_query.yaw_rad + yaw, 2. * M_PI), 0.,
                3. * kDegree);
    EXPECT_LT((found[0].submap_from_query.translation - truth.translation().head<2>()).norm(), 1.);
  }
}

TEST(PlaceIndexTest, KnowsNothingOfAnEmptyPlace) {
  const PlaceDescriber describer = ShippedDescriber();
  PlaceIndex index(describer);
  const PlaceDescriptor street = DescribeStreet(describer, 1, transform::Rigid3d());
  EXPECT_TRUE(index.Find(street, 5, nullptr).empty());
  index.Add({0, 0}, describer.Describe({}, {0., 0.}));
  EXPECT_EQ(index.size(), 0);
  EXPECT_TRUE(index.Find(street, 5, nullptr).empty());
  EXPECT_TRUE(IndexOfStreets(describer).Find(PlaceDescriptor(), 5, nullptr).empty());
}

TEST(PlaceIndexTest, AsksWhoIsAllowedAndForgetsWhoIsRemoved) {
  const PlaceDescriber describer = ShippedDescriber();
  PlaceIndex index = IndexOfStreets(describer);
  const PlaceDescriptor query = DescribeStreet(describer, 4, transform::Rigid3d());
  std::vector<submap::SubmapId> asked;
  const auto others = index.Find(query, kNumStreets, [&](const submap::SubmapId& id) {
    asked.push_back(id);
    return id.submap_index != 4;
  });
  EXPECT_EQ(others.size(), kNumStreets - 1);
  EXPECT_EQ(asked.size(), kNumStreets);
  EXPECT_TRUE(std::is_sorted(asked.begin(), asked.end()));
  for (const PlaceCandidate& other : others) EXPECT_NE(other.submap_id.submap_index, 4);
  index.Remove({0, 4});
  index.Remove({7, 4});
  EXPECT_EQ(index.size(), kNumStreets - 1);
  EXPECT_NE(index.Find(query, 1, nullptr)[0].submap_id.submap_index, 4);
}

TEST(PlaceIndexTest, TiesGoToTheSmallerIdOnAnyNumberOfThreads) {
  const PlaceDescriber describer = ShippedDescriber();
  PlaceIndex index = IndexOfStreets(describer);
  const PlaceDescriptor query = DescribeStreet(describer, 4, transform::Rigid3d());
  for (int i = 40; i > 0; --i) index.Add({1, i}, query);
  std::vector<PlaceCandidate> on_one_thread;
  for (const int threads : {1, 2, 8}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const auto found = index.Find(query, 30, nullptr);
    ASSERT_EQ(found.size(), 30);
    EXPECT_EQ(found[0].submap_id, (submap::SubmapId{0, 4}));
    for (int i = 1; i < 30; ++i) EXPECT_EQ(found[i].submap_id, (submap::SubmapId{1, i}));
    if (on_one_thread.empty()) on_one_thread = found;
    for (int i = 0; i < 30; ++i) EXPECT_EQ(found[i].score, on_one_thread[i].score);
  }
}

}  // namespace
}  // namespace cartographer::pose_graph
