// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/active_submaps.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "test/cartographer/submap/labels_with_roles.h"
#include "test/cartographer/submap/one_point.h"

namespace cartographer::submap {
namespace {

using sensor::Label;
using sensor::LabeledPointCloud;
using sensor::LabelSet;
using transform::Rigid3d;

LabelSet Labels() {
  return LabelsWithRoles(
      {{"unlabeled", "unlabeled"}, {"road", "ground"}, {"moving-car", "moving"}});
}

proto::SubmapOptions Options(int scans_per_submap) {
  proto::SubmapOptions options;
  options.set_scans_per_submap(scans_per_submap);
  options.set_resolution_m(0.5);
  options.mutable_cloud()->set_voxel_size_m(1.);
  options.mutable_cloud()->set_max_points_per_voxel(10);
  return options;
}

TEST(ActiveSubmapsTest, EachScanGoesIntoTwoSubmapsOnceTheDriveIsUnderWay) {
  const LabelSet labels = Labels();
  const LabeledPointCloud cloud = OnePoint({3.f, 0.f, 0.f}, *labels.FromName("road"));
  ActiveSubmaps active(Options(10), labels);
  std::map<int, std::shared_ptr<const Submap>> all;
  for (int scan = 0; scan < 42; ++scan) {
    const auto submaps = active.AddScan(cloud, cloud, Rigid3d());
    std::set<int> indices;
    for (const auto& [index, submap] : submaps) {
      indices.insert(index);
      all[index] = submap;
    }
    const int newest = scan / 5;
    EXPECT_EQ(indices, newest == 0 ? std::set<int>({0}) : std::set<int>({newest - 1, newest}))
        << scan;
  }
  active.FinishAll();
  ASSERT_EQ(all.size(), 9);
  for (const auto& [index, submap] : all) {
    EXPECT_TRUE(submap->finished) << index;
    EXPECT_EQ(submap->num_scans, index < 7 ? 10 : index == 7 ? 7 : 2) << index;
    EXPECT_EQ(submap->cloud.size(), 1) << index;
  }
}

TEST(ActiveSubmapsTest, NoMoreThanTwoGrowIfTheNumberOfScansIsOdd) {
  const LabelSet labels = Labels();
  ActiveSubmaps active(Options(5), labels);
  for (int scan = 0; scan < 20; ++scan) {
    EXPECT_EQ(active.AddScan({}, {}, Rigid3d()).size(), scan < 3        ? 1
                                                        : scan % 3 == 2 ? 1
                                                                        : 2)
        << scan;
  }
}

TEST(ActiveSubmapsTest, SubmapsAreLevelAndHoldPointsInTheirOwnFrame) {
  const LabelSet labels = Labels();
  const Label road = *labels.FromName("road");
  ActiveSubmaps active(Options(2), labels);
  const Eigen::Quaterniond heading(Eigen::AngleAxisd(M_PI / 2., Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond roll(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  const Rigid3d local_from_sensor({100., 50., 2.}, heading * roll);
  const LabeledPointCloud cloud = OnePoint({3.25f, 0.f, 0.f}, road);
  const auto submap = active.AddScan(cloud, cloud, local_from_sensor).at(0);
  active.FinishAll();
  // The roll is about the point's own direction, so the point stays straight ahead.
  EXPECT_LT((submap->local_from_submap.rotation().angularDistance(heading)), 1e-9);
  EXPECT_LT((submap->cloud.positions.at(0) - Eigen::Vector3f(3.25f, 0.f, 0.f)).norm(), 1e-5);
  EXPECT_EQ(submap->grid.Hits(road, {6, 0}) + submap->grid.Hits(road, {6, -1}), 1);
}

TEST(ActiveSubmapsTest, WhatMovesIsLeftOut) {
  const LabelSet labels = Labels();
  LabeledPointCloud cloud = OnePoint({3.f, 0.2f, 0.f}, *labels.FromName("road"));
  cloud.Append(OnePoint({9.f, 0.2f, 0.f}, *labels.FromName("moving-car")), 0);
  ActiveSubmaps active(Options(4), labels);
  const auto submap = active.AddScan(cloud, cloud, Rigid3d()).at(0);
  active.FinishAll();
  EXPECT_EQ(submap->grid.Labels(), std::vector<Label>{*labels.FromName("road")});
  EXPECT_EQ(submap->cloud.size(), 1);
}

TEST(ActiveSubmapsTest, EmptyScansAreScansToo) {
  ActiveSubmaps active(Options(4), Labels());
  const auto submap = active.AddScan({}, {}, Rigid3d()).at(0);
  active.FinishAll();
  EXPECT_TRUE(submap->grid.Bounds().Empty());
  EXPECT_TRUE(submap->cloud.empty());
  EXPECT_EQ(submap->num_scans, 1);
}

}  // namespace
}  // namespace cartographer::submap
