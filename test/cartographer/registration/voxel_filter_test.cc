// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/voxel_filter.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <tuple>

namespace cartographer::registration {
namespace {

using sensor::LabeledPointCloud;

// Certainty is the point's running number, so that points can be told apart.
LabeledPointCloud RandomCloud(int size) {
  constexpr int kSeed = 9;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> uniform(-5.f, 5.f);
  LabeledPointCloud cloud;
  for (int i = 0; i < size; ++i) {
    cloud.positions.emplace_back(uniform(random), uniform(random), uniform(random));
    cloud.labels.push_back(sensor::Label{static_cast<uint8_t>(i % 5)});
    cloud.certainties.push_back(static_cast<float>(i));
  }
  return cloud;
}

TEST(VoxelFilterTest, KeepsTheFirstPointOfEachVoxel) {
  const LabeledPointCloud cloud = RandomCloud(5000);
  std::set<std::tuple<int, int, int>> voxels;
  LabeledPointCloud expected;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Array3i voxel =
        (cloud.positions[i].cast<double>() / 0.7).array().floor().cast<int>();
    if (voxels.emplace(voxel.x(), voxel.y(), voxel.z()).second) expected.Append(cloud, i);
  }
  const LabeledPointCloud filtered = FilterByVoxel(cloud, 0.7);
  EXPECT_EQ(filtered.positions, expected.positions);
  EXPECT_EQ(filtered.labels, expected.labels);
  EXPECT_EQ(filtered.certainties, expected.certainties);
  EXPECT_TRUE(FilterByVoxel({}, 0.7).empty());
}

TEST(VoxelFilterTest, FiltersDownToEnough) {
  const LabeledPointCloud cloud = RandomCloud(5000);
  for (const int enough : {50, 200, 1000, 3000}) {
    const size_t size = FilterDownTo(cloud, enough, 4.).size();
    EXPECT_GE(size, enough);
    // A tenth larger voxels would have left too few.
    EXPECT_LT(size, 1.5 * enough + 100);
  }
}

TEST(VoxelFilterTest, VoxelsAreAsLargeAsAllowedAtMost) {
  const LabeledPointCloud cloud = RandomCloud(5000);
  EXPECT_EQ(FilterDownTo(cloud, 1, 1.).positions, FilterByVoxel(cloud, 1.).positions);
}

TEST(VoxelFilterTest, FewOrEqualPointsStayAsTheyAre) {
  EXPECT_TRUE(FilterDownTo({}, 10, 1.).empty());
  EXPECT_EQ(FilterDownTo(RandomCloud(10), 10, 5.).size(), 10);
  LabeledPointCloud heap = RandomCloud(100);
  for (Eigen::Vector3f& position : heap.positions) position.setZero();
  EXPECT_EQ(FilterDownTo(heap, 10, 5.).size(), 100);  // no voxel is small enough
}

}  // namespace
}  // namespace cartographer::registration
