// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/relative_error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "test/semantic_kiss/evaluation/drives.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The benchmark's definition word for word: homogeneous matrices, a search pose by pose, the angle
// from the trace.
RelativeError ByDefinition(const Poses& truth, const Poses& estimate) {
  const auto matrix_of = [](const Rigid3d& pose) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topRows<3>() = pose.Matrix();
    return matrix;
  };
  RelativeError sum;
  for (size_t first = 0; first < truth.size(); first += 10) {
    for (int length = 100; length <= 800; length += 100) {
      double driven = 0.;
      size_t last = first;
      while (last + 1 < truth.size() && driven <= length) {
        ++last;
        driven += (truth[last].translation() - truth[last - 1].translation()).norm();
      }
      if (driven <= length) continue;
      const Eigen::Matrix4d error =
          (matrix_of(estimate[first]).inverse() * matrix_of(estimate[last])).inverse() *
          (matrix_of(truth[first]).inverse() * matrix_of(truth[last]));
      const double cosine = (error.topLeftCorner<3, 3>().trace() - 1.) / 2.;
      sum.translation_percent += 100. * error.topRightCorner<3, 1>().norm() / length;
      sum.rotation_deg_per_m += std::acos(std::clamp(cosine, -1., 1.)) / length * 180. / M_PI;
      ++sum.num_segments;
    }
  }
  sum.translation_percent /= sum.num_segments;
  sum.rotation_deg_per_m /= sum.num_segments;
  return sum;
}

TEST(RelativeErrorTest, DrivenDistances) {
  EXPECT_THAT(DrivenDistances({}), IsEmpty());
  EXPECT_THAT(DrivenDistances(StraightDrive(3, 2.)), ElementsAre(0., 2., 4.));
}

TEST(RelativeErrorTest, AbsentWhereNoSegmentFits) {
  EXPECT_FALSE(ComputeRelativeErrors({}, {}));
  EXPECT_FALSE(ComputeRelativeErrors(StraightDrive(1, 1.), StraightDrive(1, 1.)));
  // Exactly 100 m are not yet more than 100 m.
  EXPECT_FALSE(ComputeRelativeErrors(StraightDrive(101, 1.), StraightDrive(101, 1.)));
  const auto errors = ComputeRelativeErrors(StraightDrive(102, 1.), StraightDrive(102, 1.));
  ASSERT_TRUE(errors);
  EXPECT_EQ(errors->overall.num_segments, 1);
}

TEST(RelativeErrorTest, IdenticalTrajectoriesHaveNone) {
  std::mt19937 random(5);
  const Poses drive = RandomDrive(400, &random);
  const auto errors = ComputeRelativeErrors(drive, drive);
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->overall.translation_percent, 0., 1e-10);
  EXPECT_NEAR(errors->overall.rotation_deg_per_m, 0., 1e-10);
}

TEST(RelativeErrorTest, OnePercentOfScaleIsOnePercent) {
  // With steps of 1/64 m (exact in binary) a segment is that much longer than its nominal length.
  constexpr double kStep_m = 1. / 64.;
  const Poses truth = StraightDrive(64 * 1000, kStep_m);
  const auto errors = ComputeRelativeErrors(truth, Scaled(truth, 1.01));
  ASSERT_TRUE(errors);
  for (const RelativeErrorOfLength& of_length : errors->by_length) {
    EXPECT_NEAR(of_length.error.translation_percent,
                (of_length.length_m + kStep_m) / of_length.length_m, 1e-9);
  }
  EXPECT_NEAR(errors->overall.translation_percent, 1., 1e-4);
  EXPECT_EQ(errors->overall.rotation_deg_per_m, 0.);
}

TEST(RelativeErrorTest, ConstantYawDrift) {
  constexpr double kDrift_deg_per_m = 0.01;
  const Poses truth = StraightDrive(64 * 300, 1. / 64.);
  Poses estimate;
  for (const Rigid3d& pose : truth) {
    const double yaw = pose.translation().x() * kDrift_deg_per_m * M_PI / 180.;
    estimate.emplace_back(pose.translation(),
                          Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
  }
  const auto errors = ComputeRelativeErrors(truth, estimate);
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->overall.rotation_deg_per_m, kDrift_deg_per_m, 1e-5);
}

TEST(RelativeErrorTest, CountsSegmentsOfEachLength) {
  // 351 m: starts at 0, 10, ..., as long as the truth goes on for more than the length.
  const auto errors = ComputeRelativeErrors(StraightDrive(352, 1.), StraightDrive(352, 1.));
  ASSERT_TRUE(errors);
  std::vector<int> counts;
  for (const RelativeErrorOfLength& of_length : errors->by_length) {
    counts.push_back(of_length.error.num_segments);
  }
  EXPECT_THAT(counts, ElementsAre(26, 16, 6, 0, 0, 0, 0, 0));
  EXPECT_EQ(errors->overall.num_segments, 48);
  EXPECT_EQ(errors->by_length[7].error.translation_percent, 0.);
}

TEST(RelativeErrorTest, LengthsAreMeasuredAlongTheGroundTruth) {
  // The estimate stands still: there are segments, and their error is the whole way.
  const Poses truth = StraightDrive(152, 1.);
  const auto errors = ComputeRelativeErrors(truth, Poses(152));
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->overall.translation_percent, 101., 1e-9);
  EXPECT_FALSE(ComputeRelativeErrors(Poses(152), truth));
}

TEST(RelativeErrorTest, EqualsTheDefinition) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Poses truth = RandomDrive(950, &random);
    const Poses estimate = WithDrift(truth, &random);
    const RelativeError expected = ByDefinition(truth, estimate);
    const auto errors = ComputeRelativeErrors(truth, estimate);
    ASSERT_TRUE(errors);
    EXPECT_GT(expected.num_segments, 100);
    EXPECT_EQ(errors->overall.num_segments, expected.num_segments);
    EXPECT_NEAR(errors->overall.translation_percent, expected.translation_percent, 1e-9);
    EXPECT_NEAR(errors->overall.rotation_deg_per_m, expected.rotation_deg_per_m, 1e-9);
  }
}

TEST(RelativeErrorTest, WorldsDoNotMatter) {
  std::mt19937 random(6);
  const Poses truth = RandomDrive(300, &random);
  const Poses estimate = WithDrift(truth, &random);
  const auto errors = ComputeRelativeErrors(truth, estimate);
  const auto moved = ComputeRelativeErrors(Moved(RandomMotion(&random, 50., 2.), truth),
                                           Moved(RandomMotion(&random, 50., 2.), estimate));
  ASSERT_TRUE(errors && moved);
  EXPECT_GT(errors->overall.translation_percent, 0.01);
  EXPECT_NEAR(moved->overall.translation_percent, errors->overall.translation_percent, 1e-9);
  EXPECT_NEAR(moved->overall.rotation_deg_per_m, errors->overall.rotation_deg_per_m, 1e-9);
}

TEST(RelativeErrorTest, MisuseIsABug) {
  EXPECT_DEATH(ComputeRelativeErrors(StraightDrive(2, 1.), StraightDrive(3, 1.)), "size");
  Poses broken = StraightDrive(200, 1.);
  broken[7] = Rigid3d::Translation({NAN, 0., 0.});
  EXPECT_DEATH(ComputeRelativeErrors(StraightDrive(200, 1.), broken), "pose 7");
}

}  // namespace
}  // namespace semantic_kiss::evaluation
