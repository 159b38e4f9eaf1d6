// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tbb/global_control.h"
#include "test/cartographer/pose_graph/place_scenes.h"

namespace cartographer::pose_graph {
namespace {

constexpr int kNumStreets = 12;
constexpr double kDegree = M_PI / 180.;

transform::Rigid3d InPlane(double x, double y, double yaw_rad) {
  return scan_matching::InSpace({{x, y}, yaw_rad});
}

class PlaceIndexTest : public ::testing::Test {
 protected:
  PlaceIndexTest() : describer_(ShippedDescriber()), index_(describer_) {
    for (int i = 0; i < kNumStreets; ++i) streets_.push_back(Street(i));
  }

  PlaceDescriptor Describe(const sensor::LabeledPointCloud& street,
                           const transform::Rigid3d& frame_from_street = {},
                           const Eigen::Vector3d& center_in_street = {0., 0., 0.}) const {
    return describer_.Describe({{street, frame_from_street}},
                               (frame_from_street * center_in_street).head<2>());
  }
  void AddAllStreets() {
    for (int i = 0; i < kNumStreets; ++i) index_.Add({0, i}, Describe(streets_[i]));
  }

  // Street `i` comes first, `query_from_street` is found to `max_offset_m` and 3 degrees.
  void ExpectFound(int i, const PlaceDescriptor& query, const transform::Rigid3d& query_from_street,
                   double max_offset_m) const {
    const auto found = index_.Find(query, 3, nullptr);
    ASSERT_EQ(found.size(), 3);
    EXPECT_EQ(found[0].submap_id.submap_index, i);
    EXPECT_GT(found[0].score, found[1].score);
    EXPECT_GT(found[1].score, found[2].score);
    const transform::Rigid3d error =
        scan_matching::InSpace(found[0].submap_from_query) * query_from_street;
    EXPECT_LT(transform::RotationAngle(error), 3. * kDegree) << "street " << i;
    // Of the query's centre, not of a frame that may be far away from it.
    const Eigen::Vector3d center(query.center.x(), query.center.y(), 0.);
    const Eigen::Vector3d offset = scan_matching::InSpace(found[0].submap_from_query) * center -
                                   query_from_street.inverse() * center;
    EXPECT_LT(offset.norm(), max_offset_m) << "street " << i;
  }

  const PlaceDescriber describer_;
  std::vector<sensor::LabeledPointCloud> streets_;
  PlaceIndex index_;
};

TEST_F(PlaceIndexTest, FindsPlacesAtAnyHeading) {
  AddAllStreets();
  for (int i = 0; i < kNumStreets; ++i) {
    const transform::Rigid3d query_from_street = InPlane(30., -200., (37. * i + 5.) * kDegree);
    ExpectFound(i, Describe(streets_[i], query_from_street), query_from_street, 1.);
  }
}

// The other lane in the other direction, half the distance of two submaps farther on.
TEST_F(PlaceIndexTest, FindsPlacesFromAFewMetresAside) {
  AddAllStreets();
  for (int i = 0; i < kNumStreets; ++i) {
    const transform::Rigid3d query_from_street = InPlane(0., 3., (180. + i) * kDegree);
    const Eigen::Vector3d center(i % 2 == 0 ? 5. : -5., 3.5, 0.);
    ExpectFound(i, Describe(streets_[i], query_from_street, center), query_from_street, 2.);
  }
}

TEST_F(PlaceIndexTest, FindsPlacesOnAnotherDayByWrongLabels) {
  AddAllStreets();
  for (int i = 0; i < kNumStreets; ++i) {
    const transform::Rigid3d query_from_street = InPlane(0., 0., 30. * i * kDegree);
    const auto other_day = WithWrongLabels(Street(i, 1), 0.2, i);
    ExpectFound(i, Describe(other_day, query_from_street), query_from_street, 1.5);
  }
}

TEST_F(PlaceIndexTest, ComparesAllPlacesFromAllViews) {
  AddAllStreets();
  const int side = describer_.views_per_side();
  for (int i = 0; i < kNumStreets; ++i) {
    const PlaceDescriptor query = Describe(streets_[i], InPlane(0., 0., i), {4., -2., 0.});
    // The oracle: every view with every place.
    std::vector<PlaceCandidate> expected;
    for (int j = 0; j < kNumStreets; ++j) {
      const PlaceDescriptor place = Describe(streets_[j]);
      PlaceCandidate best{{0, j}, {}, -1.};
      for (const BearingSpectrum& view : query.views) {
        const auto agreement =
            describer_.transform().FindBestHeading(view, place.views[side * side / 2]);
        if (agreement.score <= best.score) continue;
        best.score = agreement.score;
        best.submap_from_query.yaw_rad = agreement.yaw_rad;
      }
      expected.push_back(best);
    }
    std::stable_sort(expected.begin(), expected.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    const auto all = index_.Find(query, 100, nullptr);
    ASSERT_EQ(all.size(), kNumStreets);
    for (int rank = 0; rank < kNumStreets; ++rank) {
      EXPECT_EQ(all[rank].submap_id, expected[rank].submap_id);
      EXPECT_EQ(all[rank].score, expected[rank].score);
      EXPECT_EQ(all[rank].submap_from_query.yaw_rad, expected[rank].submap_from_query.yaw_rad);
    }
    // The coarser views alone decide who is among the few, and the best one is.
    const auto few = index_.Find(query, 3, nullptr);
    ASSERT_EQ(few.size(), 3);
    EXPECT_EQ(few[0].submap_id, all[0].submap_id);
    EXPECT_EQ(few[0].score, all[0].score);
  }
}

TEST_F(PlaceIndexTest, KnowsNothingOfEmptyPlaces) {
  const PlaceDescriptor street = Describe(streets_[1]);
  EXPECT_TRUE(index_.Find(street, 5, nullptr).empty());
  index_.Add({0, 0}, describer_.Describe({}, {0., 0.}));
  EXPECT_EQ(index_.size(), 0);
  EXPECT_TRUE(index_.Find(street, 5, nullptr).empty());
  AddAllStreets();
  EXPECT_TRUE(index_.Find(PlaceDescriptor(), 5, nullptr).empty());
  EXPECT_TRUE(index_.Find(street, 0, nullptr).empty());
  // What becomes empty is forgotten.
  index_.Add({0, 1}, describer_.Describe({}, {0., 0.}));
  EXPECT_EQ(index_.size(), kNumStreets - 1);
}

TEST_F(PlaceIndexTest, AsksWhoIsAllowedAndForgetsWhoIsRemoved) {
  AddAllStreets();
  const PlaceDescriptor query = Describe(streets_[4]);
  std::vector<submap::SubmapId> asked;
  const auto others = index_.Find(query, kNumStreets, [&](const submap::SubmapId& id) {
    asked.push_back(id);
    return id.submap_index != 4;
  });
  EXPECT_EQ(others.size(), kNumStreets - 1);
  EXPECT_EQ(asked.size(), kNumStreets);
  EXPECT_TRUE(std::is_sorted(asked.begin(), asked.end()));
  for (const PlaceCandidate& other : others) EXPECT_NE(other.submap_id.submap_index, 4);
  index_.Remove({0, 4});
  index_.Remove({7, 4});
  EXPECT_EQ(index_.size(), kNumStreets - 1);
  EXPECT_NE(index_.Find(query, 1, nullptr)[0].submap_id.submap_index, 4);
}

TEST_F(PlaceIndexTest, TiesGoToTheSmallerIdOnAnyNumberOfThreads) {
  AddAllStreets();
  const PlaceDescriptor query = Describe(streets_[4]);
  for (int i = 80; i > 0; --i) index_.Add({1, i}, query);
  std::vector<PlaceCandidate> on_one_thread;
  for (const int threads : {1, 2, 8}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const auto found = index_.Find(query, 60, nullptr);
    ASSERT_EQ(found.size(), 60);
    EXPECT_EQ(found[0].submap_id, (submap::SubmapId{0, 4}));
    for (int i = 1; i < 60; ++i) EXPECT_EQ(found[i].submap_id, (submap::SubmapId{1, i}));
    if (on_one_thread.empty()) on_one_thread = found;
    for (int i = 0; i < 60; ++i) {
      EXPECT_EQ(found[i].score, on_one_thread[i].score);
      EXPECT_EQ(found[i].submap_from_query.yaw_rad, on_one_thread[i].submap_from_query.yaw_rad);
      EXPECT_EQ(found[i].submap_from_query.translation,
                on_one_thread[i].submap_from_query.translation);
    }
  }
}

// What is not kept cannot be told from what is: results do not depend on the order of insertion.
TEST_F(PlaceIndexTest, DoesNotDependOnTheOrderOfAdding) {
  AddAllStreets();
  PlaceIndex reversed(describer_);
  for (int i = kNumStreets - 1; i >= 0; --i) reversed.Add({0, i}, Describe(streets_[i]));
  const PlaceDescriptor query = Describe(streets_[7], InPlane(0., 0., 1.));
  const auto a = index_.Find(query, kNumStreets, nullptr);
  const auto b = reversed.Find(query, kNumStreets, nullptr);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].submap_id, b[i].submap_id);
    EXPECT_EQ(a[i].score, b[i].score);
  }
}

}  // namespace
}  // namespace cartographer::pose_graph
