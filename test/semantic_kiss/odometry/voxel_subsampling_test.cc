// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/voxel_subsampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "tbb/global_control.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelMask;

constexpr Label kRoad{1};
constexpr Label kPole{2};

LabelMask Poles() {
  LabelMask mask;
  mask.Insert(kPole);
  return mask;
}

proto::SubsamplingOptions Options(double voxel_size_m, int max_points, int max_critical) {
  proto::SubsamplingOptions options;
  options.set_voxel_size_m(voxel_size_m);
  options.set_max_points_per_voxel(max_points);
  options.set_max_critical_points_per_voxel(max_critical);
  return options;
}

// Certainty is the point's running number, so that points can be told apart.
LabeledPointCloud RandomCloud(int seed, int size, double share_of_poles) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1.f, 1.f);
  LabeledPointCloud cloud;
  for (int i = 0; i < size; ++i) {
    cloud.positions.emplace_back(20.f * uniform(random), 20.f * uniform(random), uniform(random));
    cloud.labels.push_back(std::abs(uniform(random)) < share_of_poles ? kPole : kRoad);
    cloud.certainties.push_back(static_cast<float>(i));
  }
  return cloud;
}

// What the header promises, point by point and with an ordinary map.
std::vector<float> Reference(const LabeledPointCloud& cloud, double voxel_size_m, int max_points,
                             int max_critical) {
  std::map<std::tuple<int, int, int>, std::pair<int, int>> voxels;
  std::vector<float> kept;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Array3d voxel = (cloud.positions[i].cast<double>().array() / voxel_size_m).floor();
    auto& [ordinary, critical] = voxels[{static_cast<int>(voxel.x()), static_cast<int>(voxel.y()),
                                         static_cast<int>(voxel.z())}];
    if (ordinary < max_points) {
      ++ordinary;
      kept.push_back(cloud.certainties[i]);
    } else if (cloud.labels[i] == kPole && critical < max_critical) {
      ++critical;
      kept.push_back(cloud.certainties[i]);
    }
  }
  return kept;
}

std::vector<float> Sorted(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  return values;
}

TEST(VoxelSubsamplingTest, KeepsTheFirstPointsOfEachVoxelAndSparesCriticalOnes) {
  // More points than are worked on at once, so that the parts have to be put together.
  const LabeledPointCloud cloud = RandomCloud(11, 60000, 0.1);
  for (const auto& [voxel_size_m, max_points, max_critical] :
       {std::tuple{0.5, 1, 20}, {1.5, 1, 3}, {1.0, 3, 0}, {4.0, 2, 1000}}) {
    const LabeledPointCloud thinned =
        Subsample(cloud, Options(voxel_size_m, max_points, max_critical), Poles());
    EXPECT_EQ(Sorted(thinned.certainties),
              Reference(cloud, voxel_size_m, max_points, max_critical));
    for (size_t i = 0; i < thinned.size(); ++i) {
      const size_t original = static_cast<size_t>(thinned.certainties[i]);
      ASSERT_EQ(thinned.positions[i], cloud.positions[original]);
      ASSERT_EQ(thinned.labels[i], cloud.labels[original]);
    }
  }
}

TEST(VoxelSubsamplingTest, APoleSurvivesBothSubsamplings) {
  LabeledPointCloud cloud = RandomCloud(12, 20000, 0.);
  for (int i = 0; i < 15; ++i) {
    cloud.positions.emplace_back(5.05f, 5.05f, 0.01f * i);
    cloud.labels.push_back(kPole);
    cloud.certainties.push_back(-1.f);
  }
  const LabeledPointCloud for_map = Subsample(cloud, Options(0.5, 1, 20), Poles());
  const LabeledPointCloud for_icp = Subsample(for_map, Options(1.5, 1, 20), Poles());
  EXPECT_EQ(std::count(for_map.labels.begin(), for_map.labels.end(), kPole), 15);
  EXPECT_EQ(std::count(for_icp.labels.begin(), for_icp.labels.end(), kPole), 15);
  const LabeledPointCloud plain = Subsample(cloud, Options(0.5, 1, 0), Poles());
  EXPECT_EQ(std::count(plain.labels.begin(), plain.labels.end(), kPole), 0);
}

TEST(VoxelSubsamplingTest, OrderHasNoDirection) {
  // Along a line that is scanned from one end to the other the ranks in the result must not follow
  // the ranks in the scan.
  LabeledPointCloud line;
  for (int i = 0; i < 1000; ++i) {
    line.positions.emplace_back(i + 0.5f, 0.5f, 0.5f);
    line.labels.push_back(kRoad);
    line.certainties.push_back(static_cast<float>(i));
  }
  const LabeledPointCloud thinned = Subsample(line, Options(1., 1, 0), Poles());
  ASSERT_EQ(thinned.size(), 1000);
  double covariance = 0.;
  for (int i = 0; i < 1000; ++i) covariance += (i - 499.5) * (thinned.certainties[i] - 499.5);
  EXPECT_LT(std::abs(covariance) / (1000. * 1000. * 1000. / 12.), 0.2);
}

TEST(VoxelSubsamplingTest, SameOnAnyNumberOfThreads) {
  const LabeledPointCloud cloud = RandomCloud(13, 100000, 0.05);
  std::vector<std::vector<float>> results;
  for (const int threads : {1, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(Subsample(cloud, Options(0.5, 1, 20), Poles()).certainties);
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(VoxelSubsamplingTest, EmptyAndSingle) {
  EXPECT_TRUE(Subsample({}, Options(1., 1, 1), Poles()).empty());
  EXPECT_EQ(Subsample(RandomCloud(14, 1, 0.), Options(1., 1, 1), Poles()).size(), 1);
}

}  // namespace
}  // namespace semantic_kiss::odometry
