// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/voxel_thinning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "glog/logging.h"

namespace cartographer::io {
namespace {

using ::testing::HasSubstr;

void Add(double x, double y, double z, MapPoint point, VoxelThinning* thinning) {
  const absl::Status status = thinning->Add({x, y, z}, point);
  CHECK(status.ok()) << status;
}

MapPoint Point(int label, float certainty = 1.f, float intensity = 0.f) {
  return {{}, certainty, intensity, sensor::Label{static_cast<uint8_t>(label)}};
}

TEST(VoxelThinningTest, StartsEmpty) { EXPECT_EQ(VoxelThinning(1.).size(), 0u); }

TEST(VoxelThinningTest, MakesTheMeanOfACube) {
  VoxelThinning thinning(1.);
  Add(-0.25, 0.5, 100.25, Point(3, 0.5f, 0.25f), &thinning);
  Add(-0.75, 0.5, 100.75, Point(3, 1.f, 0.75f), &thinning);
  Add(0.25, 0.5, 100.25, Point(3, 0.25f), &thinning);  // the next cube
  ASSERT_EQ(thinning.size(), 2u);
  EXPECT_EQ(thinning.At(0).position, Eigen::Vector3f(-0.5f, 0.5f, 100.5f));
  EXPECT_EQ(thinning.At(0).certainty, 0.75f);
  EXPECT_EQ(thinning.At(0).intensity, 0.5f);
  EXPECT_EQ(thinning.At(1).certainty, 0.25f);
}

TEST(VoxelThinningTest, TheMostFrequentLabelWins) {
  VoxelThinning thinning(1.);
  for (const int label : {2, 1, 2, 0, 0, 0, 1, 2}) {
    Add(0.1 * label, 0.5, 0.5, Point(label), &thinning);
  }
  ASSERT_EQ(thinning.size(), 1u);
  EXPECT_EQ(thinning.At(0).label, sensor::Label{2});
  EXPECT_FLOAT_EQ(thinning.At(0).position.x(), 0.2f) << "only its own points make the mean";
  Add(0.1, 0.5, 0.5, Point(1), &thinning);
  EXPECT_EQ(thinning.At(0).label, sensor::Label{1}) << "the smaller one on ties";
}

TEST(VoxelThinningTest, UnlabeledYieldsToAnyOther) {
  VoxelThinning thinning(1.);
  for (const int label : {0, 0, 5}) Add(0.5, 0.5, 0.5, Point(label), &thinning);
  Add(5.5, 0.5, 0.5, Point(0), &thinning);
  EXPECT_EQ(thinning.At(0).label, sensor::Label{5});
  EXPECT_EQ(thinning.At(1).label, sensor::kUnlabeled);
}

TEST(VoxelThinningTest, FarFromTheOriginItIsAsPrecise) {
  VoxelThinning thinning(0.1);
  for (int i = 0; i < 4; ++i) Add(50000.012, -80000.033, 0.05, Point(1), &thinning);
  ASSERT_EQ(thinning.size(), 1u);
  EXPECT_EQ(thinning.At(0).position.x(), static_cast<float>(50000.012));
  EXPECT_EQ(thinning.At(0).position.y(), static_cast<float>(-80000.033));
}

TEST(VoxelThinningTest, AgreesWithCountingAllPointsOfEachCube) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-4., 4.);
  VoxelThinning thinning(0.5);
  struct Seen {
    size_t order;
    std::map<int, int> labels;
  };
  std::map<std::tuple<int, int, int>, Seen> cubes;
  for (int i = 0; i < 5000; ++i) {
    const double x = uniform(random), y = uniform(random), z = 0.2 * uniform(random);
    const int label = static_cast<int>(random() % 4);
    Add(x, y, z, Point(label), &thinning);
    const auto index = [](double value) { return static_cast<int>(std::floor(value / 0.5)); };
    const auto cube =
        cubes.emplace(std::make_tuple(index(x), index(y), index(z)), Seen{cubes.size(), {}}).first;
    ++cube->second.labels[label];
  }
  ASSERT_EQ(thinning.size(), cubes.size());
  for (const auto& [cube, seen] : cubes) {
    int best = 0;
    for (const auto& [label, count] : seen.labels) {
      if (best == 0 || count > seen.labels.at(best)) best = label;
    }
    const MapPoint point = thinning.At(seen.order);
    EXPECT_EQ(static_cast<int>(point.label), best);
    const Eigen::Vector3d corner =
        0.5 * Eigen::Vector3d(std::get<0>(cube), std::get<1>(cube), std::get<2>(cube));
    const Eigen::Vector3d offset = point.position.cast<double>() - corner;
    EXPECT_TRUE((offset.array() >= -1e-6).all() && (offset.array() <= 0.5 + 1e-6).all());
  }
}

TEST(VoxelThinningTest, WhatCannotBeCountedIsAnError) {
  VoxelThinning thinning(0.01);
  const absl::Status status = thinning.Add({0., 10486., 1.}, Point(1));
  EXPECT_THAT(std::string(status.message()), HasSubstr("(0, 10486, 1) m is too far away"));
  EXPECT_FALSE(thinning.Add({NAN, 0., 0.}, Point(1)).ok());
  EXPECT_TRUE(thinning.Add({0., 10485., 1.}, Point(1)).ok());
}

}  // namespace
}  // namespace cartographer::io
