// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <cmath>

#include "test/semantic_kiss/evaluation/drives.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;
using ::testing::HasSubstr;

std::string ErrorOf(const Poses& truth, const Poses& estimate) {
  const auto evaluation = Evaluate(truth, estimate, VehicleFrame::kLidar);
  EXPECT_EQ(evaluation.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(evaluation.status().message());
}

TEST(EvaluationTest, CollectsEveryFigure) {
  std::mt19937 random(8);
  const Poses truth = RandomDrive(300, &random);
  const Poses estimate = WithDrift(truth, &random);
  const auto evaluation = Evaluate(truth, estimate, VehicleFrame::kLidar);
  ASSERT_TRUE(evaluation.ok()) << evaluation.status();
  EXPECT_EQ(evaluation->driven_m, DrivenDistances(truth).back());
  const Metrics metrics = MetricsOf(*evaluation);
  const RelativeError relative = ComputeRelativeErrors(truth, estimate)->overall;
  EXPECT_EQ(metrics.rte_percent, relative.translation_percent);
  EXPECT_EQ(metrics.rte_deg_per_m, relative.rotation_deg_per_m);
  EXPECT_EQ(metrics.ate_3d_m, ComputeAbsoluteError3d(truth, estimate)->rmse_m);
  EXPECT_EQ(metrics.ate_2d_m,
            ComputeAbsoluteError2d(truth, estimate, VehicleFrame::kLidar)->rmse_m);
  EXPECT_EQ(evaluation->final_error.position_error_m,
            ComputeFinalError(truth, estimate, VehicleFrame::kLidar).position_error_m);
}

TEST(EvaluationTest, FiguresThatDoNotExistAreAbsent) {
  const Metrics short_drive =
      MetricsOf(*Evaluate(StraightDrive(50, 1.), StraightDrive(50, 1.), VehicleFrame::kLidar));
  EXPECT_FALSE(short_drive.rte_percent || short_drive.rte_deg_per_m);
  EXPECT_TRUE(short_drive.ate_3d_m && short_drive.ate_2d_m);
  const Metrics two_poses = MetricsOf(*Evaluate(Poses(2), Poses(2), VehicleFrame::kLidar));
  EXPECT_FALSE(two_poses.ate_3d_m || two_poses.ate_2d_m);
}

TEST(EvaluationTest, CountsMustBeEqual) {
  EXPECT_EQ(ErrorOf(Poses(4541), Poses(4540)),
            "the ground truth has 4541 poses, the estimate 4540; give the range of scans that was "
            "estimated");
  EXPECT_THAT(ErrorOf({}, {}), HasSubstr("there are no poses to compare"));
}

TEST(EvaluationTest, NotFinitePosesAreNamed) {
  Poses broken(3);
  broken[1] = Rigid3d({0., 0., 0.}, Eigen::Quaterniond(NAN, 0., 0., 0.));
  EXPECT_THAT(ErrorOf(Poses(3), broken), HasSubstr("pose 1 of the estimate is not finite"));
  broken[1] = Rigid3d::Translation({0., INFINITY, 0.});
  EXPECT_THAT(ErrorOf(broken, Poses(3)), HasSubstr("pose 1 of the ground truth is not finite"));
}

TEST(EvaluationTest, CameraAndLidarDoNotMix) {
  const Poses lidar = StraightDrive(10, 1.);
  Poses camera;
  for (int i = 0; i < 10; ++i) camera.push_back(Rigid3d::Translation({0., 0., 1. * i}));
  EXPECT_THAT(std::string(CheckSameBody(camera, lidar).message()),
              HasSubstr("the ground truth holds poses of a camera, the estimate of a lidar"));
  EXPECT_TRUE(CheckSameBody(camera, camera).ok());
  // Standing still tells nothing, so it is no contradiction.
  EXPECT_TRUE(CheckSameBody(camera, Poses(10)).ok());
}

TEST(EvaluationTest, GroundTruthOfScans) {
  const Poses truth = StraightDrive(10, 1.);
  const auto positions = [&truth](int first_scan, std::optional<int> num_scans) {
    const auto part = GroundTruthOfScans(truth, first_scan, num_scans);
    EXPECT_TRUE(part.ok()) << part.status();
    std::vector<double> positions;
    if (!part.ok()) return positions;
    for (const Rigid3d& pose : *part) {
      positions.push_back(pose.translation().x());
    }
    return positions;
  };
  EXPECT_THAT(positions(7, std::nullopt), ::testing::ElementsAre(7., 8., 9.));
  EXPECT_THAT(positions(2, 2), ::testing::ElementsAre(2., 3.));
  EXPECT_EQ(positions(0, std::nullopt).size(), 10);
  EXPECT_THAT(positions(10, std::nullopt), ::testing::IsEmpty());
  EXPECT_THAT(positions(10, 0), ::testing::IsEmpty());
}

TEST(EvaluationTest, GroundTruthOfScansThatAreNotThere) {
  const Poses truth = StraightDrive(10, 1.);
  const std::pair<int, std::optional<int>> ranges[] = {
      {11, std::nullopt}, {-1, 3}, {5, 6}, {0, -1}, {5, INT_MAX}, {INT_MIN, INT_MAX}};
  for (const auto& [first_scan, num_scans] : ranges) {
    EXPECT_EQ(GroundTruthOfScans(truth, first_scan, num_scans).status().code(),
              absl::StatusCode::kOutOfRange);
  }
  EXPECT_EQ(GroundTruthOfScans(truth, 5, 6).status().message(),
            "the ground truth has 10 poses; 6 from pose 5 on are not among them; choose scans "
            "within it");
}

}  // namespace
}  // namespace semantic_kiss::evaluation
