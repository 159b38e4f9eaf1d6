// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/compressed_point_cloud.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace cartographer::sensor {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Eigen::Vector3d> RandomPositions(int size, double range_m, int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-range_m, range_m);
  std::vector<Eigen::Vector3d> positions(size);
  for (Eigen::Vector3d& position : positions) {
    position = {uniform(random), uniform(random), 0.1 * uniform(random)};
  }
  return positions;
}

std::string ErrorOf(int num_points, const std::vector<int>& data) {
  proto::CompressedPointCloud proto;
  proto.set_num_points(num_points);
  for (const int number : data) proto.add_point_data(number);
  const auto positions = DecompressPositions(proto);
  EXPECT_EQ(positions.status().code(), absl::StatusCode::kDataLoss);
  return std::string(positions.status().message());
}

TEST(CompressedPointCloudTest, EmptyCloud) {
  const auto compressed = CompressPositions({});
  ASSERT_TRUE(compressed.ok());
  EXPECT_EQ(compressed->proto.ByteSizeLong(), 0u);
  EXPECT_TRUE(DecompressPositions(compressed->proto)->empty());
}

TEST(CompressedPointCloudTest, LayoutByHand) {
  // 1.025 m is step 1 of block 1, -0.001 m step 1023 of block -1.
  const auto compressed =
      CompressPositions({{1.025, 0.002, 0.}, {-0.001, 0., 0.003}, {1.024, 0., 0.}});
  ASSERT_TRUE(compressed.ok());
  EXPECT_EQ(compressed->proto.num_points(), 3);
  EXPECT_THAT(compressed->proto.point_data(),
              ElementsAre(1, -1, 0, 0, 1023 + (3 << 20), 2, 1, 0, 0, 1 + (2 << 10), 0));
  EXPECT_THAT(compressed->order, ElementsAre(1, 0, 2));
}

TEST(CompressedPointCloudTest, RoundTripIsWithinHalfAMillimetreAndInOrder) {
  const auto positions = RandomPositions(5000, 120., 1);
  const auto compressed = CompressPositions(positions);
  ASSERT_TRUE(compressed.ok());
  const auto decompressed = DecompressPositions(compressed->proto);
  ASSERT_TRUE(decompressed.ok());
  ASSERT_EQ(decompressed->size(), positions.size());
  for (size_t i = 0; i < positions.size(); ++i) {
    const Eigen::Vector3d error = (*decompressed)[i] - positions[compressed->order[i]];
    EXPECT_LE(error.cwiseAbs().maxCoeff(), 0.5e-3 + 1e-9);
  }
}

TEST(CompressedPointCloudTest, RoundingHappensOnceEvenThroughFloatsInAnotherFrame) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1., -2., 0.5).normalized()).toRotationMatrix();
  for (const double range_m : {1., 100., 4000.}) {
    const auto compressed = CompressPositions(RandomPositions(5000, range_m, 2));
    ASSERT_TRUE(compressed.ok());
    std::vector<Eigen::Vector3d> positions = *DecompressPositions(compressed->proto);
    for (Eigen::Vector3d& position : positions) {
      const Eigen::Vector3f elsewhere = (rotation.transpose() * position).cast<float>();
      position = rotation * elsewhere.cast<double>();
    }
    const auto again = CompressPositions(positions);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->proto.SerializeAsString(), compressed->proto.SerializeAsString());
  }
}

TEST(CompressedPointCloudTest, RefusesWhatCannotBeStored) {
  EXPECT_TRUE(CompressPositions({{8388.607, -8388.607, 0.}}).ok());
  for (const double bad : {8388.608, -8388.608, 1e300, std::nan(""), HUGE_VAL}) {
    const auto compressed = CompressPositions({{0., 0., 0.}, {0., bad, 0.}});
    EXPECT_EQ(compressed.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(compressed.status().message()), HasSubstr("point 1 at (0, "));
  }
}

TEST(CompressedPointCloudTest, MalformedDataIsAnError) {
  EXPECT_THAT(ErrorOf(1, {}), HasSubstr("1 points cannot be in 0 numbers"));
  EXPECT_THAT(ErrorOf(-1, {1, 0, 0, 0, 0}), HasSubstr("-1 points"));
  EXPECT_THAT(ErrorOf(2147483647, {1, 0, 0, 0, 0}), HasSubstr("cannot be in 5 numbers"));
  EXPECT_THAT(ErrorOf(1, {1, 0, 0}), HasSubstr("does not fit the remaining 3 numbers"));
  EXPECT_THAT(ErrorOf(1, {2, 0, 0, 0, 5}), HasSubstr("a block of 2 points does not fit"));
  EXPECT_THAT(ErrorOf(1, {-1, 0, 0, 0, 5}), HasSubstr("a block of -1 points does not fit"));
  EXPECT_THAT(ErrorOf(2, {1, 0, 0, 0, 5}), HasSubstr("blocks hold 1 points instead of 2"));
  EXPECT_THAT(ErrorOf(1, {1, 0, 8192, 0, 5}), HasSubstr("beyond 8388 m"));
  EXPECT_THAT(ErrorOf(1, {1, -2147483647, 0, 0, 5}), HasSubstr("beyond 8388 m"));
  EXPECT_THAT(ErrorOf(1, {1, 0, -8192, 0, 0}), HasSubstr("beyond 8388 m"));
  EXPECT_THAT(ErrorOf(1, {1, 0, 0, 0, -1}), HasSubstr("-1 is no position"));
  EXPECT_THAT(ErrorOf(1, {1, 0, 0, 0, 1 << 30}), HasSubstr("is no position"));
}

}  // namespace
}  // namespace cartographer::sensor
