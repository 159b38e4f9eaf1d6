// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/labeled_point_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cartographer::sensor {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LabeledPointCloud TwoPoints() {
  LabeledPointCloud cloud;
  cloud.positions = {{1.f, 2.f, 3.f}, {4.f, 5.f, 6.f}};
  cloud.labels = {kUnlabeled, Label{7}};
  cloud.certainties = {0.25f, 0.5f};
  return cloud;
}

TEST(LabeledPointCloudTest, AppendsAllColumnsThatTheOtherHas) {
  LabeledPointCloud full = TwoPoints();
  full.intensities = {0.1f, 0.2f};
  full.times = {-0.1f, 0.f};
  LabeledPointCloud cloud;
  cloud.Append(full, 1);
  cloud.Append(full, 0);
  cloud.CheckConsistent();
  EXPECT_EQ(cloud.size(), 2u);
  EXPECT_EQ(cloud.positions[0], Eigen::Vector3f(4.f, 5.f, 6.f));
  EXPECT_THAT(cloud.labels, ElementsAre(Label{7}, kUnlabeled));
  EXPECT_THAT(cloud.certainties, ElementsAre(0.5f, 0.25f));
  EXPECT_THAT(cloud.intensities, ElementsAre(0.2f, 0.1f));
  EXPECT_THAT(cloud.times, ElementsAre(0.f, -0.1f));

  LabeledPointCloud bare;
  bare.Append(TwoPoints(), 0);
  bare.CheckConsistent();
  EXPECT_THAT(bare.intensities, IsEmpty());
  EXPECT_THAT(bare.times, IsEmpty());
}

TEST(LabeledPointCloudTest, ClearEmptiesEveryColumn) {
  LabeledPointCloud cloud = TwoPoints();
  cloud.times = {0.f, 0.f};
  cloud.intensities = {0.f, 0.f};
  EXPECT_FALSE(cloud.empty());
  cloud.Clear();
  EXPECT_TRUE(cloud.empty());
  cloud.CheckConsistent();
}

TEST(LabeledPointCloudDeathTest, ColumnsHaveOneEntryAPoint) {
  LabeledPointCloud cloud = TwoPoints();
  cloud.CheckConsistent();
  cloud.labels.pop_back();
  EXPECT_DEATH(cloud.CheckConsistent(), "labels.size");
  cloud = TwoPoints();
  cloud.certainties.push_back(1.f);
  EXPECT_DEATH(cloud.CheckConsistent(), "certainties.size");
  cloud = TwoPoints();
  cloud.times = {0.f};
  EXPECT_DEATH(cloud.CheckConsistent(), "times");
  cloud = TwoPoints();
  cloud.intensities = {0.f, 0.f, 0.f};
  EXPECT_DEATH(cloud.CheckConsistent(), "intensities");
}

}  // namespace
}  // namespace cartographer::sensor
