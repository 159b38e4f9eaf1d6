// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/along_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "test/testing/small_map.h"

namespace semantic_kiss::report {
namespace {

using cartographer::common::FromUnixSeconds;
using cartographer::common::Time;
using cartographer::transform::Rigid3d;
using semantic_kiss_testing::RandomPose;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;

std::vector<Rigid3d> RandomPoses(int count, std::mt19937* random) {
  std::vector<Rigid3d> poses;
  for (int i = 0; i < count; ++i) poses.push_back(RandomPose(random));
  return poses;
}

TEST(AlongPathTest, ASteadyDriveHasOneSpeed) {
  std::vector<Time> times;
  std::vector<Rigid3d> poses;
  for (int i = 0; i < 30; ++i) {
    times.push_back(FromUnixSeconds(0.1 * i));
    poses.push_back(Rigid3d::Translation({0.6 * i, 0.8 * i, 0.}));
  }
  EXPECT_THAT(Speeds(times, poses), Each(DoubleNear(10., 1e-6)));
}

TEST(AlongPathTest, WhereNoTimePassesThereIsNoSpeed) {
  EXPECT_THAT(Speeds({}, {}), ElementsAre());
  EXPECT_THAT(Speeds({FromUnixSeconds(1.)}, {Rigid3d()}), ElementsAre(0.));
}

TEST(AlongPathTest, HeightsAndDistances) {
  const std::vector<Rigid3d> poses = {Rigid3d::Translation({1., 2., 3.}),
                                      Rigid3d::Translation({4., 6., 1.})};
  EXPECT_THAT(Heights(poses), ElementsAre(0., -2.));
  EXPECT_THAT(Heights({}), ElementsAre());
  EXPECT_THAT(
      Distances(poses, {Rigid3d::Translation({1., 2., 3.}), Rigid3d::Translation({1., 2., 1.})}),
      ElementsAre(0., 5.));
  EXPECT_EQ(PlanePositions(poses)[1], Eigen::Vector2d(4., 6.));
}

TEST(AlongPathTest, AlignmentUndoesAnyMotion) {
  constexpr int kSeed = 20260303;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  for (const int count : {1, 2, 3, 40}) {
    const std::vector<Rigid3d> target = RandomPoses(count, &random);
    const Rigid3d motion = RandomPose(&random);
    std::vector<Rigid3d> moved;
    for (const Rigid3d& pose : target) moved.push_back(motion * pose);
    EXPECT_THAT(Distances(AlignedOnto(target, moved), target), Each(DoubleNear(0., 1e-6)));
  }
}

TEST(AlongPathTest, AlignmentIsNoWorseThanNone) {
  constexpr int kSeed = 20260304;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const std::vector<Rigid3d> target = RandomPoses(20, &random), poses = RandomPoses(20, &random);
  const auto sum_of_squares = [&](const std::vector<Rigid3d>& candidate) {
    double sum = 0.;
    for (const double distance : Distances(candidate, target)) sum += distance * distance;
    return sum;
  };
  EXPECT_LT(sum_of_squares(AlignedOnto(target, poses)), sum_of_squares(poses));
}

}  // namespace
}  // namespace semantic_kiss::report
