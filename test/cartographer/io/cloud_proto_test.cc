// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/cloud_proto.h"

#include <cmath>

namespace cartographer::io {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr size_t kNumLabels = 3;
const Eigen::Quaterniond kLevel = Eigen::Quaterniond::Identity();

sensor::LabeledPointCloud ThreePoints() {
  sensor::LabeledPointCloud cloud;
  cloud.positions = {{5.f, 0.f, 0.f}, {-5.f, 0.f, 0.f}, {0.f, 0.f, 0.f}};
  cloud.labels = {sensor::Label{2}, sensor::Label{1}, sensor::kUnlabeled};
  cloud.certainties = {1.f, 0.5f, 0.f};
  cloud.intensities = {0.25f, 0.f, 1.f};
  cloud.times = {0.f, -0.1f, 0.05f};
  return cloud;
}

std::string WriteError(const sensor::LabeledPointCloud& cloud) {
  return std::string(ToProto(cloud, kNumLabels, kLevel).status().message());
}

std::string ReadError(const CloudProto& proto) {
  const auto cloud = FromProto(proto.positions, &proto.attributes, kNumLabels, kLevel);
  return std::string(cloud.status().message());
}

TEST(CloudProtoTest, ColumnsStayWithTheirPoints) {
  const auto proto = ToProto(ThreePoints(), kNumLabels, kLevel);
  ASSERT_TRUE(proto.ok());
  const auto cloud = FromProto(proto->positions, &proto->attributes, kNumLabels, kLevel);
  ASSERT_TRUE(cloud.ok()) << cloud.status();
  cloud->CheckConsistent();
  ASSERT_EQ(cloud->size(), 3u);
  // By ascending x.
  EXPECT_THAT(cloud->labels, ElementsAre(sensor::Label{1}, sensor::kUnlabeled, sensor::Label{2}));
  EXPECT_THAT(cloud->certainties, ElementsAre(128 / 255.f, 0.f, 1.f));
  EXPECT_THAT(cloud->intensities, ElementsAre(0.f, 1.f, 64 / 255.f));
  EXPECT_THAT(cloud->times, ElementsAre(-0.1f, 0.05f, 0.f));
}

TEST(CloudProtoTest, PositionsAreStoredInTheGivenFrame) {
  const Eigen::Quaterniond pitch(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()));
  const auto proto = ToProto(ThreePoints(), kNumLabels, pitch);
  ASSERT_TRUE(proto.ok());
  const auto stored = FromProto(proto->positions, nullptr, kNumLabels, kLevel);
  const auto back = FromProto(proto->positions, &proto->attributes, kNumLabels, pitch);
  // Pitched down, the first point lies lowest and comes first.
  EXPECT_NEAR(stored->positions[0].x(), 5. * std::cos(0.1), 1e-3);
  EXPECT_NEAR(stored->positions[0].z(), -5. * std::sin(0.1), 1e-3);
  EXPECT_LT((back->positions[0] - Eigen::Vector3f(5.f, 0.f, 0.f)).norm(), 1e-3f);
}

TEST(CloudProtoTest, WithoutAttributesPointsAreUnlabeled) {
  const auto proto = ToProto(ThreePoints(), kNumLabels, kLevel);
  const auto cloud = FromProto(proto->positions, nullptr, 1, kLevel);
  ASSERT_TRUE(cloud.ok());
  cloud->CheckConsistent();
  EXPECT_THAT(cloud->labels, Each(sensor::kUnlabeled));
  EXPECT_THAT(cloud->certainties, Each(1.f));
  EXPECT_TRUE(cloud->intensities.empty());
}

TEST(CloudProtoTest, WhatDoesNotFitIsNamed) {
  sensor::LabeledPointCloud cloud = ThreePoints();
  cloud.labels[1] = sensor::Label{3};
  EXPECT_EQ(WriteError(cloud), "point 1: label 3 is not in the set of 3");
  cloud = ThreePoints();
  cloud.certainties[2] = -0.1f;
  EXPECT_EQ(WriteError(cloud), "point 2: certainty -0.1 is not in [0, 1]");
  cloud = ThreePoints();
  cloud.intensities[0] = 1.5f;
  EXPECT_EQ(WriteError(cloud), "point 0: intensity 1.5 is not in [0, 1]");
  cloud = ThreePoints();
  cloud.times[0] = HUGE_VALF;
  EXPECT_EQ(WriteError(cloud), "point 0: time inf s is not within +-1000 s");
}

TEST(CloudProtoTest, ColumnsOfOtherLengthsAreAnError) {
  const CloudProto good = *ToProto(ThreePoints(), kNumLabels, kLevel);
  EXPECT_EQ(ReadError(good), "");
  CloudProto bad = good;
  bad.attributes.mutable_labels()->push_back('\0');
  EXPECT_THAT(ReadError(bad), HasSubstr("3 points, but 4 labels"));
  bad = good;
  bad.attributes.clear_certainties();
  EXPECT_THAT(ReadError(bad), HasSubstr("0 certainties"));
  bad = good;
  bad.attributes.mutable_intensities()->pop_back();
  EXPECT_THAT(ReadError(bad), HasSubstr("2 intensities"));
  bad = good;
  bad.attributes.add_times_us(5);
  EXPECT_THAT(ReadError(bad), HasSubstr("4 times"));
  bad = good;
  bad.attributes.mutable_labels()->at(1) = '\x03';
  EXPECT_EQ(ReadError(bad), "point 1: label 3 is not in the set of 3");
}

}  // namespace
}  // namespace cartographer::io
