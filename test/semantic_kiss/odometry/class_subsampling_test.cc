// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/class_subsampling.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "semantic_kiss/odometry/voxel_subsampling.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelMask;

constexpr Label kRoad{1};
constexpr Label kPole{2};
constexpr Label kWall{3};

LabelMask Mask(std::initializer_list<Label> labels) {
  LabelMask mask;
  for (const Label label : labels) mask.Insert(label);
  return mask;
}

proto::SubsamplingOptions Options(double rest_m, const std::vector<double>& classes_m) {
  proto::SubsamplingOptions options;
  options.set_voxel_size_m(rest_m);
  options.set_max_points_per_voxel(1);
  options.set_max_critical_points_per_voxel(2);
  for (const double size_m : classes_m) options.add_class_voxels()->set_voxel_size_m(size_m);
  return options;
}

// Certainty is the point's running number, so that points can be told apart.
LabeledPointCloud RandomCloud(int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-10.f, 10.f);
  LabeledPointCloud cloud;
  for (int i = 0; i < 4000; ++i) {
    cloud.positions.emplace_back(uniform(random), uniform(random), uniform(random) / 10.f);
    cloud.labels.push_back(Label{static_cast<uint8_t>(i % 4)});
    cloud.certainties.push_back(static_cast<float>(i));
  }
  return cloud;
}

std::vector<float> Certainties(const std::vector<LabeledPointCloud>& clouds) {
  std::vector<float> all;
  for (const LabeledPointCloud& cloud : clouds) {
    all.insert(all.end(), cloud.certainties.begin(), cloud.certainties.end());
  }
  return all;
}

TEST(ClassSubsamplingTest, WithoutGroupsItIsTheSubsamplingOfAll) {
  const LabeledPointCloud cloud = RandomCloud(1);
  const proto::SubsamplingOptions options = Options(0.7, {});
  EXPECT_EQ(SubsampleByClass(cloud, options, {}, Mask({kPole})).certainties,
            Subsample(cloud, options, Mask({kPole})).certainties);
}

TEST(ClassSubsamplingTest, AGroupOfAllClassesIsTheSubsamplingOfAll) {
  const LabeledPointCloud cloud = RandomCloud(2);
  const LabelMask all = Mask({Label{0}, kRoad, kPole, kWall});
  EXPECT_EQ(SubsampleByClass(cloud, Options(5., {0.7}), {all}, Mask({kPole})).certainties,
            Subsample(cloud, Options(0.7, {}), Mask({kPole})).certainties);
}

TEST(ClassSubsamplingTest, GroupsAreSubsampledAsIfTheyWereAlone) {
  const LabeledPointCloud cloud = RandomCloud(3);
  const LabelMask flat = Mask({kRoad, kPole}), upright = Mask({kWall});
  const LabelMask rest = Mask({Label{0}});
  const auto only = [&](std::initializer_list<LabelMask> dropped) {
    LabelMask mask;
    for (const LabelMask& labels : dropped) mask.Insert(labels);
    return cartographer::sensor::WithoutLabels(cloud, mask);
  };
  for (const auto& [flat_m, upright_m, rest_m] :
       {std::array{0.5, 0.9, 1.3}, std::array{0.7, 0.7, 0.7}}) {
    EXPECT_EQ(SubsampleByClass(cloud, Options(rest_m, {flat_m, upright_m}), {flat, upright},
                               Mask({kPole}))
                  .certainties,
              Certainties({Subsample(only({upright, rest}), Options(flat_m, {}), Mask({kPole})),
                           Subsample(only({flat, rest}), Options(upright_m, {}), Mask({kPole})),
                           Subsample(only({flat, upright}), Options(rest_m, {}), Mask({kPole}))}));
  }
}

TEST(ClassSubsamplingTest, TwoPointsOfAVoxelStayIfTheirGroupsDiffer) {
  LabeledPointCloud cloud;
  for (const Label label : {kRoad, kWall, kPole, kRoad}) {
    cloud.positions.emplace_back(0.1f, 0.1f, 0.1f);
    cloud.labels.push_back(label);
    cloud.certainties.push_back(1.f);
  }
  const LabeledPointCloud result =
      SubsampleByClass(cloud, Options(1., {1.}), {Mask({kRoad})}, LabelMask());
  EXPECT_EQ(result.labels, (std::vector<Label>{kRoad, kWall}));
}

TEST(ClassSubsamplingTest, NothingComesOfNothing) {
  EXPECT_TRUE(SubsampleByClass({}, Options(1., {1.}), {Mask({kRoad})}, LabelMask()).empty());
}

}  // namespace
}  // namespace semantic_kiss::odometry
