// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/verify_closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/transform/se3.h"
#include "tbb/global_control.h"
#include "tbb/task_arena.h"
#include "test/cartographer/pose_graph/street_scene.h"

namespace cartographer::pose_graph {
namespace {

using transform::Rigid3d;

constexpr double kDegree = M_PI / 180.;

// What a match in the plane and the odometry leave of the truth: a cell and half a degree off, and
// no idea of the height.
Rigid3d GuessNear(const Rigid3d& truth) {
  const Eigen::Quaterniond turn(
      Eigen::AngleAxisd(0.5 * kDegree, Eigen::Vector3d(0.2, -0.3, 0.9).normalized()));
  return Rigid3d(truth.translation() + Eigen::Vector3d(0.2, -0.15, 3.), turn * truth.rotation());
}

void ExpectNear(const Rigid3d& pose, const Rigid3d& truth) {
  const Rigid3d error = truth.inverse() * pose;
  EXPECT_LT(error.translation().norm(), 0.05);
  EXPECT_LT(transform::RotationAngle(error), 0.2 * kDegree);
}

class VerifyClosureTest : public ::testing::Test {
 protected:
  const proto::VerificationOptions options_ = ShippedVerificationOptions();
  const std::vector<ScenePoint> street_ = MakeStreet({});
  const ClosureTarget target_ = TargetOf(street_, options_);
};

TEST_F(VerifyClosureTest, RecoversKnownPosesInAllSixDegrees) {
  const Rigid3d forward = NodeOnStreet(6., 1.5, 0.1);
  const Rigid3d inverted = NodeOnStreet(-4., 2.8, M_PI - 0.07);
  const Rigid3d shifted = NodeOnStreet(12., -2.5, -0.2);
  for (const Rigid3d& truth : {forward, inverted, shifted}) {
    const ClosureReport report =
        VerifyClosure(SeeFrom(street_, truth, {}), GuessNear(truth), target_, options_);
    EXPECT_EQ(report.verdict, Verdict::kAccepted) << VerdictName(report.verdict);
    ExpectNear(report.submap_from_node, truth);
    EXPECT_GT(report.overlap, 0.9);
    EXPECT_GT(report.inlier_ratio, 0.9);
    ASSERT_TRUE(report.height_offset_m.has_value());
    EXPECT_NEAR(*report.height_offset_m, -3., 0.1);
    EXPECT_NEAR(*report.height_mismatch_m, 0., 0.05);
    EXPECT_NEAR(report.correction_m, 0.25, 0.06);
    EXPECT_NEAR(report.correction_deg, 0.5, 0.2);
  }
}

TEST_F(VerifyClosureTest, OtherCarsAndWrongLabelsDoNotHarm) {
  const std::vector<ScenePoint> another_day = MakeStreet({/*seed=*/1, /*parked_cars=*/2});
  const Rigid3d truth = NodeOnStreet(3., -1.5, M_PI + 0.05);
  const sensor::LabeledPointCloud cloud =
      SeeFrom(another_day, truth, {/*visit=*/1, /*share=*/0.1, /*label_noise=*/0.2});
  const ClosureReport report = VerifyClosure(cloud, GuessNear(truth), target_, options_);
  EXPECT_EQ(report.verdict, Verdict::kAccepted) << VerdictName(report.verdict);
  ExpectNear(report.submap_from_node, truth);
}

TEST_F(VerifyClosureTest, WrongPlacesAreRejected) {
  const std::vector<ScenePoint> elsewhere = MakeStreet({/*seed=*/7, /*parked_cars=*/3});
  std::set<Verdict> verdicts;
  for (double x = -20.; x <= 20.; x += 5.) {
    for (const double yaw : {0., M_PI}) {
      const Rigid3d pose = NodeOnStreet(x, 0., yaw);
      const auto cloud = SeeFrom(elsewhere, pose, {});
      const ClosureReport report = VerifyClosure(cloud, pose, target_, options_);
      EXPECT_FALSE(report.accepted()) << x << " " << yaw;
      verdicts.insert(report.verdict);
    }
  }
  EXPECT_EQ(verdicts.count(Verdict::kIcpFailed), 0u);
}

TEST_F(VerifyClosureTest, TheRightPlaceShiftedOrTurnedRoundIsRejected) {
  const Rigid3d truth = NodeOnStreet(5., 1., 0.);
  const auto cloud = SeeFrom(street_, truth, {});
  for (const double shift : {-10., 10.}) {
    const Rigid3d guess = NodeOnStreet(5. + shift, 1., 0.);
    EXPECT_FALSE(VerifyClosure(cloud, guess, target_, options_).accepted()) << shift;
  }
  EXPECT_FALSE(VerifyClosure(cloud, NodeOnStreet(5., -1., M_PI), target_, options_).accepted());
}

TEST_F(VerifyClosureTest, VerdictsNameTheReason) {
  const Rigid3d truth = NodeOnStreet(5., 1., 0.);
  const auto cloud = SeeFrom(street_, truth, {});
  const auto verdict = [&](const std::string& overrides) {
    const auto options = ShippedVerificationOptions(overrides);
    return VerifyClosure(cloud, GuessNear(truth), TargetOf(street_, options), options).verdict;
  };
  EXPECT_EQ(verdict(""), Verdict::kAccepted);
  const std::string acceptance = "CLOSURE_VERIFICATION.acceptance.";
  EXPECT_EQ(verdict(acceptance + "min_points = 100000"), Verdict::kTooFewPoints);
  EXPECT_EQ(verdict(acceptance + "min_overlap = 1.0 " + acceptance + "overlap_distance_m = 0.2"),
            Verdict::kLowOverlap);
  EXPECT_EQ(verdict(acceptance + "inlier_distance_m = 0.05"), Verdict::kLowInlierRatio);
  EXPECT_EQ(verdict(acceptance + "max_rms_error_m = 0.02"), Verdict::kLargeError);
  EXPECT_EQ(verdict(acceptance + "max_correction_m = 0.1"), Verdict::kLargeCorrection);
  EXPECT_EQ(verdict(acceptance + "max_correction_deg = 0.1"), Verdict::kLargeCorrection);
  EXPECT_EQ(verdict(acceptance + "max_height_mismatch_m = 0.0"), Verdict::kHeightMismatch);
  EXPECT_EQ(verdict(acceptance + "max_sigma_m = 0.001"), Verdict::kDegenerate);
  EXPECT_EQ(verdict(acceptance + "max_sigma_deg = 0.001"), Verdict::kDegenerate);
  EXPECT_EQ(verdict("CLOSURE_VERIFICATION.icp.min_points = 100000"), Verdict::kIcpFailed);
}

TEST_F(VerifyClosureTest, NothingToGoByIsNoClosure) {
  const Rigid3d guess = NodeOnStreet(5., 1., 0.3);
  const auto cloud = SeeFrom(street_, guess, {});
  const ClosureTarget nothing({}, sensor::LabelSet(), options_);
  const ClosureReport reports[] = {
      VerifyClosure({}, guess, target_, options_), VerifyClosure({}, guess, nothing, options_),
      VerifyClosure(cloud, guess, nothing, options_),
      VerifyClosure(cloud, Rigid3d::Translation({1000., 0., 0.}), target_, options_)};
  for (const ClosureReport& report : reports) {
    EXPECT_EQ(report.verdict, Verdict::kIcpFailed);
    EXPECT_FALSE(report.accepted());
    EXPECT_EQ(report.overlap, 0.);
    EXPECT_TRUE(report.information.isZero());
  }
  EXPECT_EQ(reports[0].submap_from_node.Matrix(), guess.Matrix());
}

TEST_F(VerifyClosureTest, SameBitsOnAnyNumberOfThreads) {
  const Rigid3d truth = NodeOnStreet(6., 1.5, 0.1);
  const auto cloud = SeeFrom(street_, truth, {});
  const auto verify = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(threads);
    return arena.execute([&] { return VerifyClosure(cloud, GuessNear(truth), target_, options_); });
  };
  const ClosureReport reference = verify(1);
  for (const int threads : {2, 8}) {
    const ClosureReport report = verify(threads);
    EXPECT_EQ(report.submap_from_node.Matrix(), reference.submap_from_node.Matrix());
    EXPECT_EQ(report.information, reference.information);
    EXPECT_EQ(report.inlier_ratio, reference.inlier_ratio);
  }
}

TEST(VerdictTest, NamesAreWordsAndDiffer) {
  std::set<absl::string_view> names;
  for (int i = 0; i < kNumVerdicts; ++i) names.insert(VerdictName(static_cast<Verdict>(i)));
  EXPECT_EQ(names.size(), static_cast<size_t>(kNumVerdicts));
  EXPECT_EQ(names.count("low_inlier_ratio"), 1u);
}

}  // namespace
}  // namespace cartographer::pose_graph
