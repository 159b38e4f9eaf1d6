// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/active_planar_submaps.h"

#include <gtest/gtest.h>

#include <string>
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
  return LabelsWithRoles({{"unlabeled", "unlabeled"}, {"wall", ""}, {"moving-car", "moving"}});
}

proto::PlanarSubmapOptions Options(int scans_per_submap) {
  proto::PlanarSubmapOptions options;
  options.set_scans_per_submap(scans_per_submap);
  options.mutable_grid()->set_resolution_m(0.5);
  options.mutable_grid()->set_hit_probability(0.6);
  options.mutable_grid()->set_miss_probability(0.4);
  options.mutable_grid()->set_cast_rays(true);
  options.mutable_cloud()->set_voxel_size_m(1.);
  options.mutable_cloud()->set_max_points_per_voxel(10);
  return options;
}

TEST(ActivePlanarSubmapsTest, TheOlderSubmapIsTheReference) {
  const LabelSet labels = Labels();
  ActivePlanarSubmaps active(Options(4), labels);
  EXPECT_EQ(active.reference().grid, nullptr);
  const std::vector<std::vector<int>> expected = {{0}, {0}, {0, 1}, {0, 1}, {1, 2}, {1, 2}, {2, 3}};
  // After a scan: full submaps have left.
  const std::vector<double> reference_x = {0., 0., 0., 2., 2., 4., 4.};
  for (size_t scan = 0; scan < expected.size(); ++scan) {
    const auto submaps = active.AddScan(OnePoint({3.f, 0.f, 0.f}, *labels.FromName("wall")),
                                        Rigid3d::Translation({1. * scan, 0., 0.}));
    std::vector<int> indices;
    for (const auto& [index, submap] : submaps) indices.push_back(index);
    EXPECT_EQ(indices, expected[scan]);
    ASSERT_NE(active.reference().grid, nullptr);
    EXPECT_EQ(active.reference().local_from_submap.translation().x(), reference_x[scan]);
  }
}

TEST(ActivePlanarSubmapsTest, FinishedSubmapsHoldWhatRaysLeftStanding) {
  const LabelSet labels = Labels();
  const Label wall = *labels.FromName("wall"), car = *labels.FromName("moving-car");
  ActivePlanarSubmaps active(Options(100), labels);
  const Rigid3d origin;
  std::shared_ptr<const Submap> submap =
      active.AddScan(OnePoint({3.2f, 0.2f, 0.f}, wall), origin).at(0);
  // It was no wall: the next scans look through it.
  for (int i = 0; i < 3; ++i) active.AddScan(OnePoint({6.2f, 0.2f, 0.f}, wall), origin);
  active.AddScan(OnePoint({0.2f, 4.2f, 0.f}, car), origin);
  active.AddScan(OnePoint({0.2f, -4.3f, 0.f}, sensor::kUnlabeled), origin);
  EXPECT_FALSE(submap->finished);
  active.FinishAll();
  ASSERT_TRUE(submap->finished);
  EXPECT_EQ(submap->num_scans, 6);
  EXPECT_EQ(submap->grid.Hits(wall, {6, 0}), 0);
  EXPECT_EQ(submap->grid.Hits(wall, {12, 0}), 3);
  EXPECT_EQ(submap->grid.Hits(sensor::kUnlabeled, {0, -9}), 1);
  EXPECT_EQ(submap->grid.Labels(), (std::vector<Label>{sensor::kUnlabeled, wall}));
  EXPECT_EQ(submap->cloud.size(), 3);
  EXPECT_EQ(active.reference().grid, nullptr);
}

TEST(ActivePlanarSubmapsTest, GridsLieInTheFramesOfTheirSubmaps) {
  const LabelSet labels = Labels();
  ActivePlanarSubmaps active(Options(100), labels);
  const Rigid3d local_from_sensor(
      {10., 5., 0.}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2., Eigen::Vector3d::UnitZ())));
  active.AddScan(OnePoint({3.2f, 0.2f, 1.f}, *labels.FromName("wall")), local_from_sensor);
  const auto reference = active.reference();
  EXPECT_LT((reference.local_from_submap.translation() - local_from_sensor.translation()).norm(),
            1e-12);
  EXPECT_GT(reference.grid->Probability({6, 0}), 0.5f);
}

}  // namespace
}  // namespace cartographer::submap
