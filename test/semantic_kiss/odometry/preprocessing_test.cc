// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/preprocessing.h"

#include <gtest/gtest.h>

#include <limits>

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelMask;
using cartographer::transform::Twist;

constexpr Label kRoad{1};
constexpr Label kMovingCar{2};

LabelMask MovingCars() {
  LabelMask mask;
  mask.Insert(kMovingCar);
  return mask;
}

proto::PreprocessingOptions Options() {
  proto::PreprocessingOptions options;
  options.set_min_range_m(2.);
  options.set_max_range_m(100.);
  options.set_label_max_range_m(100.);
  options.set_deskew(true);
  return options;
}

void AddPoint(float x, float y, float z, Label label, LabeledPointCloud* cloud) {
  cloud->positions.emplace_back(x, y, z);
  cloud->labels.push_back(label);
  cloud->certainties.push_back(0.5f);
}

TEST(PreprocessingTest, LabelsEndWhereTheyAreNoLongerTrusted) {
  proto::PreprocessingOptions options = Options();
  options.set_label_max_range_m(50.);
  LabeledPointCloud scan;
  AddPoint(49.f, 0.f, 0.f, kRoad, &scan);
  AddPoint(50.f, 0.f, 0.f, kRoad, &scan);  // exactly there: no label
  AddPoint(30.f, 45.f, 0.f, kRoad, &scan);
  const PreprocessedScan result = Preprocess(scan, Twist::Zero(), MovingCars(), options);
  EXPECT_EQ(result.points.labels, (std::vector<Label>{kRoad, cartographer::sensor::kUnlabeled,
                                                      cartographer::sensor::kUnlabeled}));
  EXPECT_EQ(result.points.positions, scan.positions);
}

TEST(PreprocessingTest, CountsWhatItDropsAndWhy) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  LabeledPointCloud scan;
  AddPoint(10.f, 0.f, 0.f, kRoad, &scan);
  AddPoint(kNan, 0.f, 0.f, kRoad, &scan);
  AddPoint(1.f, kInfinity, 0.f, kRoad, &scan);
  AddPoint(1.f, 1.f, 0.f, kRoad, &scan);
  AddPoint(2.f, 0.f, 0.f, kRoad, &scan);    // exactly at the minimum: out
  AddPoint(100.f, 0.f, 0.f, kRoad, &scan);  // exactly at the maximum: out
  AddPoint(20.f, 0.f, 0.f, kMovingCar, &scan);
  AddPoint(200.f, 0.f, 0.f, kMovingCar, &scan);
  AddPoint(0.f, 50.f, 1.f, kRoad, &scan);

  const PreprocessedScan result = Preprocess(scan, Twist::Zero(), MovingCars(), Options());
  EXPECT_EQ(result.counts.kept, 2);
  EXPECT_EQ(result.counts.not_finite, 2);
  EXPECT_EQ(result.counts.out_of_range, 4);
  EXPECT_EQ(result.counts.moving, 1);
  ASSERT_EQ(result.points.size(), 2);
  EXPECT_EQ(result.points.positions[1], Eigen::Vector3f(0.f, 50.f, 1.f));
  EXPECT_EQ(result.points.labels[1], kRoad);
  EXPECT_EQ(result.points.certainties[1], 0.5f);
  EXPECT_FALSE(result.deskewed);
}

TEST(PreprocessingTest, KeepsTheOrderOfLargeScans) {
  LabeledPointCloud scan;
  for (int i = 0; i < 50000; ++i) {
    AddPoint(3.f + 0.001f * i, 0.f, 0.f, i % 3 == 0 ? kMovingCar : kRoad, &scan);
  }
  const PreprocessedScan result = Preprocess(scan, Twist::Zero(), MovingCars(), Options());
  EXPECT_EQ(result.points.size(), 33333);
  for (size_t i = 1; i < result.points.size(); ++i) {
    ASSERT_LT(result.points.positions[i - 1].x(), result.points.positions[i].x());
  }
}

TEST(PreprocessingTest, DeskewsBeforeItLooksAtTheRange) {
  LabeledPointCloud scan;
  AddPoint(99.5f, 0.f, 0.f, kRoad, &scan);
  AddPoint(99.5f, 0.f, 0.f, kRoad, &scan);
  scan.times = {-0.1f, 0.f};
  Twist backwards = Twist::Zero();
  backwards[0] = -1.;  // at the end of the sweep the sensor is 1 m behind its start
  const PreprocessedScan result = Preprocess(scan, backwards, {}, Options());
  EXPECT_TRUE(result.deskewed);
  EXPECT_EQ(result.counts.out_of_range, 1);
  ASSERT_EQ(result.points.size(), 1);
  EXPECT_NEAR(result.points.positions[0].x(), 99.5f, 1e-4);

  proto::PreprocessingOptions options = Options();
  options.set_deskew(false);
  EXPECT_EQ(Preprocess(scan, backwards, {}, options).counts.kept, 2);
}

TEST(PreprocessingTest, EmptyScan) {
  const PreprocessedScan result = Preprocess({}, Twist::Zero(), MovingCars(), Options());
  EXPECT_TRUE(result.points.empty());
  EXPECT_EQ(result.counts.kept, 0);
}

}  // namespace
}  // namespace semantic_kiss::odometry
