// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/labeled_voxel_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace cartographer::registration {
namespace {

using sensor::kUnlabeled;
using sensor::Label;
using sensor::LabeledPointCloud;
using sensor::LabelMask;
using transform::Rigid3d;

constexpr Label kRoad{1};
constexpr Label kPole{2};

LabelMask Poles() {
  LabelMask mask;
  mask.Insert(kPole);
  return mask;
}

proto::VoxelMapOptions Options(double voxel_size_m = 1., int max_points = 20,
                               int max_critical = 20) {
  proto::VoxelMapOptions options;
  options.set_voxel_size_m(voxel_size_m);
  options.set_max_points_per_voxel(max_points);
  options.set_max_critical_points_per_voxel(max_critical);
  return options;
}

LabeledPointCloud RandomCloud(std::mt19937* random, int size, float extent_m, Label label) {
  std::uniform_real_distribution<float> uniform(-extent_m, extent_m);
  LabeledPointCloud cloud;
  for (int i = 0; i < size; ++i) {
    cloud.positions.emplace_back(uniform(*random), uniform(*random), uniform(*random));
    cloud.labels.push_back(label);
    cloud.certainties.push_back(1.f);
  }
  return cloud;
}

TEST(LabeledVoxelMapTest, FindsTheNearestPointLikeAnExhaustiveSearch) {
  constexpr int kSeed = 3;
  std::mt19937 random(kSeed);
  LabeledVoxelMap map(Options(), Poles());
  map.Insert(RandomCloud(&random, 3000, 4.f, kRoad), Rigid3d());
  map.Insert(RandomCloud(&random, 500, 4.f, kPole), Rigid3d());
  const LabeledPointCloud points = map.ToPointCloud();
  ASSERT_EQ(points.size(), map.num_points());

  std::uniform_real_distribution<double> uniform(-5., 5.);
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d query(uniform(random), uniform(random), uniform(random));
    // Up to one voxel the 27 neighbours see everything.
    const double max_distance_m = 0.05 + 0.85 * i / 2000.;
    double nearest = max_distance_m;
    size_t nearest_index = points.size();
    for (size_t j = 0; j < points.size(); ++j) {
      const double distance = (points.positions[j].cast<double>() - query).norm();
      if (distance < nearest) {
        nearest = distance;
        nearest_index = j;
      }
    }
    const LabeledVoxelMap::Nearest result = map.FindNearest(query, max_distance_m);
    const auto& neighbor = result.neighbor;
    for (size_t j = 0; j < points.size(); ++j) {
      if (j == nearest_index) continue;
      ASSERT_GE((points.positions[j].cast<double>() - query).norm(), result.others_beyond_m - 1e-5);
    }
    ASSERT_EQ(neighbor.has_value(), nearest_index < points.size()) << i;
    if (!neighbor.has_value()) continue;
    ++found;
    EXPECT_NEAR((neighbor->position - query).norm(), nearest, 1e-6);
    EXPECT_EQ(neighbor->label, points.labels[nearest_index]);
    EXPECT_LT((neighbor->position - points.positions[nearest_index].cast<double>()).norm(), 1e-6);
  }
  EXPECT_GT(found, 500);
}

TEST(LabeledVoxelMapTest, KeepsTheLimitAndTheSpacingOfOrdinaryPoints) {
  constexpr int kSeed = 4;
  std::mt19937 random(kSeed);
  LabeledVoxelMap map(Options(1., 20), Poles());
  map.Insert(RandomCloud(&random, 20000, 0.5f, kRoad), Rigid3d::Translation({0.5, 0.5, 0.5}));
  EXPECT_LE(map.num_points(), 20);
  EXPECT_GE(map.num_points(), 10);
  const LabeledPointCloud points = map.ToPointCloud();
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GE((points.positions[i] - points.positions[j]).norm(), 1. / std::sqrt(20.) - 1e-6);
    }
  }
}

TEST(LabeledVoxelMapTest, CriticalPointsStayInFullVoxelsUpToTheirOwnLimit) {
  constexpr int kSeed = 5;
  std::mt19937 random(kSeed);
  LabeledVoxelMap map(Options(1., 20, 30), Poles());
  const Rigid3d to_first_voxel = Rigid3d::Translation({0.5, 0.5, 0.5});
  map.Insert(RandomCloud(&random, 20000, 0.5f, kRoad), to_first_voxel);
  const size_t ordinary = map.num_points();
  map.Insert(RandomCloud(&random, 25, 0.5f, kPole), to_first_voxel);
  EXPECT_EQ(map.num_points(), ordinary + 25);
  map.Insert(RandomCloud(&random, 1000, 0.5f, kPole), to_first_voxel);
  size_t critical = 0;
  for (const Label label : map.ToPointCloud().labels) critical += label == kPole;
  // Beyond their own limit they count as ordinary ones, which are full or nearly so.
  EXPECT_GE(critical, 30);
  EXPECT_LE(map.num_points(), 20 + 30);
}

TEST(LabeledVoxelMapTest, ForgetsWhatIsFar) {
  LabeledPointCloud cloud;
  for (int i = 0; i < 100; ++i) {
    cloud.positions.emplace_back(i + 0.5f, 0.f, 0.f);
    cloud.labels.push_back(kRoad);
    cloud.certainties.push_back(1.f);
  }
  LabeledVoxelMap map(Options(), Poles());
  map.Insert(cloud, Rigid3d());
  map.RemoveFarFrom({0., 0., 0.}, 50.);
  EXPECT_EQ(map.num_voxels(), 50);
  EXPECT_EQ(map.num_points(), 50);
  EXPECT_FALSE(map.FindNearest({70.5, 0., 0.}, 1.).neighbor.has_value());
  ASSERT_TRUE(map.FindNearest({20.6, 0., 0.}, 1.).neighbor.has_value());
  EXPECT_NEAR(map.FindNearest({20.6, 0., 0.}, 1.).neighbor->position.x(), 20.5, 1e-6);
  // Freed storage is used again.
  map.Insert(cloud, Rigid3d());
  EXPECT_EQ(map.num_points(), 100);
  EXPECT_TRUE(map.FindNearest({70.5, 0., 0.}, 1.).neighbor.has_value());
}

TEST(LabeledVoxelMapTest, KeepsItsPrecisionFarFromTheOrigin) {
  LabeledPointCloud cloud;
  cloud.positions.emplace_back(0.123456f, 0.654321f, 0.5f);
  cloud.labels.push_back(kRoad);
  cloud.certainties.push_back(1.f);
  LabeledVoxelMap map(Options(), Poles());
  const Eigen::Vector3d far(50000., -30000., 1000.);
  map.Insert(cloud, Rigid3d::Translation(far));
  const auto neighbor = map.FindNearest(far + Eigen::Vector3d(0.1, 0.7, 0.4), 1.).neighbor;
  ASSERT_TRUE(neighbor.has_value());
  EXPECT_LT((neighbor->position - far - cloud.positions[0].cast<double>()).norm(), 1e-6);
}

TEST(LabeledVoxelMapTest, EmptyMapHasNoNeighbors) {
  LabeledVoxelMap map(Options(), Poles());
  EXPECT_TRUE(map.Empty());
  EXPECT_FALSE(map.FindNearest({0., 0., 0.}, 10.).neighbor.has_value());
  EXPECT_TRUE(map.ToPointCloud().empty());
  map.RemoveFarFrom({0., 0., 0.}, 1.);
  map.Insert({}, Rigid3d());
  EXPECT_TRUE(map.Empty());
}

TEST(LabeledVoxelMapTest, ClearedMapStartsAfresh) {
  constexpr int kSeed = 6;
  std::mt19937 random(kSeed);
  const LabeledPointCloud cloud = RandomCloud(&random, 1000, 3.f, kRoad);
  LabeledVoxelMap map(Options(), Poles());
  map.Insert(cloud, Rigid3d());
  const LabeledPointCloud before = map.ToPointCloud();
  map.Clear();
  EXPECT_TRUE(map.Empty());
  map.Insert(cloud, Rigid3d());
  EXPECT_EQ(map.ToPointCloud().positions, before.positions);
}

LabeledPointCloud Points(const std::vector<std::pair<Eigen::Vector3f, Label>>& points) {
  LabeledPointCloud cloud;
  for (const auto& [position, label] : points) {
    cloud.positions.push_back(position);
    cloud.labels.push_back(label);
    cloud.certainties.push_back(1.f);
  }
  return cloud;
}

TEST(LabeledVoxelMapTest, PrefersPointsOfTheSameLabel) {
  LabeledVoxelMap map(Options(), {});
  map.Insert(Points({{{0.2f, 0.5f, 0.5f}, kRoad},         // 0.1 m from the query
                     {{0.7f, 0.5f, 0.5f}, kPole},         // 0.4 m
                     {{0.3f, 0.9f, 0.5f}, kUnlabeled}}),  // 0.4 m
             Rigid3d());
  const Eigen::Vector3d query(0.3, 0.5, 0.5);
  const auto choice = [&](Label label, double factor) {
    return map.FindPreferred(query, label, factor).neighbor->label;
  };
  // 0.05 * 0.4^2 = 0.008 < 0.1^2 = 0.01 < 0.07 * 0.4^2 = 0.0112.
  EXPECT_EQ(choice(kPole, 0.05), kPole);
  EXPECT_EQ(choice(kPole, 0.07), kRoad);
  EXPECT_EQ(choice(kRoad, 0.05), kRoad);
  // A point without a label disagrees with nobody, and nobody with it.
  EXPECT_EQ(choice(kUnlabeled, 0.05), kRoad);
  EXPECT_EQ(choice(Label{7}, 0.05), kUnlabeled);
  EXPECT_EQ(choice(Label{7}, 0.07), kRoad);
}

TEST(LabeledVoxelMapTest, FindsThePreferredPointLikeAnExhaustiveSearch) {
  constexpr int kSeed = 8;
  std::mt19937 random(kSeed);
  LabeledVoxelMap map(Options(), {});
  map.Insert(RandomCloud(&random, 1500, 3.f, kRoad), Rigid3d());
  map.Insert(RandomCloud(&random, 300, 3.f, kPole), Rigid3d());
  map.Insert(RandomCloud(&random, 100, 3.f, kUnlabeled), Rigid3d());
  const LabeledPointCloud points = map.ToPointCloud();
  std::uniform_real_distribution<double> uniform(-4., 4.);
  for (int i = 0; i < 1500; ++i) {
    const Eigen::Vector3d query(uniform(random), uniform(random), uniform(random));
    const Label label{static_cast<uint8_t>(i % 4)};
    const double factor = i % 2 == 0 ? 0.05 : 0.4;
    // All that lies in the 27 voxels around the query.
    double best = 1e9, second = 1e9;
    for (size_t j = 0; j < points.size(); ++j) {
      const Eigen::Vector3d position = points.positions[j].cast<double>();
      if (((map.VoxelAt(position) - map.VoxelAt(query)).abs() > 1).any()) continue;
      const Label other = points.labels[j];
      const bool agrees = other == label || other == kUnlabeled || label == kUnlabeled;
      const double measure = (position - query).squaredNorm() * (agrees ? factor : 1.);
      second = std::min(second, std::max(best, measure));
      best = std::min(best, measure);
    }
    const LabeledVoxelMap::Nearest found = map.FindPreferred(query, label, factor);
    ASSERT_EQ(found.neighbor.has_value(), best < 1e9) << i;
    if (!found.neighbor.has_value()) continue;
    const Label other = found.neighbor->label;
    const bool agrees = other == label || other == kUnlabeled || label == kUnlabeled;
    EXPECT_NEAR((found.neighbor->position - query).squaredNorm() * (agrees ? factor : 1.), best,
                1e-5);
    EXPECT_LE(found.others_beyond_m, std::sqrt(second) + 1e-4);
  }
}

TEST(LabeledVoxelMapTest, PointsCrowdIfTheyMay) {
  constexpr int kSeed = 4;
  std::mt19937 random(kSeed);
  proto::VoxelMapOptions options = Options(1., 20);
  options.set_allow_crowding(true);
  LabeledVoxelMap map(options, {});
  map.Insert(RandomCloud(&random, 15, 0.01f, kRoad), Rigid3d::Translation({0.5, 0.5, 0.5}));
  EXPECT_EQ(map.num_points(), 15);
  map.Insert(RandomCloud(&random, 15, 0.01f, kRoad), Rigid3d::Translation({0.5, 0.5, 0.5}));
  EXPECT_EQ(map.num_points(), 20);
}

TEST(LabeledVoxelMapTest, LabeledPointsDisplaceUnlabeledOnesOfFullVoxels) {
  proto::VoxelMapOptions options = Options(1., 2);
  options.set_allow_crowding(true);
  options.set_displace_unlabeled(true);
  LabeledVoxelMap map(options, {});
  const auto labels_after = [&](Label label) {
    map.Insert(Points({{{0.5f, 0.5f, 0.5f}, label}}), Rigid3d());
    return map.ToPointCloud().labels;
  };
  EXPECT_EQ(labels_after(kRoad), (std::vector<Label>{kRoad}));
  EXPECT_EQ(labels_after(kUnlabeled), (std::vector<Label>{kRoad, kUnlabeled}));
  EXPECT_EQ(labels_after(kUnlabeled), (std::vector<Label>{kRoad, kUnlabeled}));
  EXPECT_EQ(labels_after(kPole), (std::vector<Label>{kRoad, kPole}));
  EXPECT_EQ(labels_after(kPole), (std::vector<Label>{kRoad, kPole}));
}

}  // namespace
}  // namespace cartographer::registration
