// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/odometry_uncertainty.h"

#include <algorithm>
#include <cmath>

#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using transform::Twist;

proto::OdometryErrorOptions Options(const std::string& random, const std::string& systematic) {
  return OptimizationDefaults(
             "local function sigmas(m, up, t, y) return { forward_m = m, left_m = m, up_m = up, "
             "tilt_deg = t, heading_deg = y } end\n"
             "OPTIMIZATION.odometry.random = sigmas(" +
             random +
             ")\n"
             "OPTIMIZATION.odometry.systematic = sigmas(" +
             systematic + ")")
      .odometry();
}

// The definition, step by step.
PoseVariance StepByStep(const proto::OdometryErrorOptions& options, const Poses& poses, int start,
                        int end) {
  const Twist random = ToTwist(options.random()), systematic = ToTwist(options.systematic());
  const double random_m = random.head<3>().maxCoeff(), random_rad = random.tail<3>().maxCoeff();
  PoseVariance variance;
  Eigen::Vector3d levers = Eigen::Vector3d::Zero();
  double length_m = 0.;
  for (int i = start + 1; i <= end; ++i) {
    const double step_m = std::max(options.min_step_m(),
                                   (poses[i].translation() - poses[i - 1].translation()).norm());
    const Eigen::Vector3d lever = poses[end].translation() - poses[i].translation();
    variance.translation_m2 +=
        step_m * (random_m * random_m + random_rad * random_rad * lever.squaredNorm());
    variance.rotation_rad2 += step_m * random_rad * random_rad;
    levers += step_m * lever;
    length_m += step_m;
  }
  const double apart_m = (poses[end].translation() - poses[start].translation()).norm();
  variance.translation_m2 += std::pow(systematic.head<3>().maxCoeff() * apart_m, 2) +
                             std::pow(systematic.tail<3>().maxCoeff() * levers.norm(), 2);
  variance.rotation_rad2 += std::pow(systematic.tail<3>().maxCoeff() * length_m, 2);
  return variance;
}

TEST(OdometryUncertaintyTest, IsTheSumOverTheSteps) {
  const auto options = Options("0.02, 0.03, 0.02, 0.01", "0.002, 0.001, 0.001, 0.002");
  Poses poses = Laps(1.5);
  // Far from the origin, where sums of squares lose digits.
  for (auto& pose : poses) pose = transform::Rigid3d::Translation({5000., -3000., 0.}) * pose;
  Graph graph;
  AddTrajectory(0, poses, &graph);
  const OdometryUncertainty uncertainty(options, OdometryChain(options, graph, 0));
  for (const auto& [start, end] : {std::pair(0, 179), {3, 4}, {10, 100}, {50, 170}}) {
    const PoseVariance expected = StepByStep(options, poses, start, end);
    for (const PoseVariance& variance :
         {uncertainty.Between(start, end), uncertainty.Between(end, start)}) {
      EXPECT_NEAR(variance.translation_m2, expected.translation_m2, 1e-7 * expected.translation_m2);
      EXPECT_NEAR(variance.rotation_rad2, expected.rotation_rad2, 1e-7 * expected.rotation_rad2);
    }
  }
}

TEST(OdometryUncertaintyTest, IsNothingBetweenANodeAndItself) {
  const auto options = Options("0.02, 0.03, 0.02, 0.01", "0.002, 0.001, 0.001, 0.002");
  Graph graph;
  AddTrajectory(0, Laps(0.1), &graph);
  const PoseVariance variance =
      OdometryUncertainty(options, OdometryChain(options, graph, 0)).Between(4, 4);
  EXPECT_EQ(variance.translation_m2, 0.);
  EXPECT_EQ(variance.rotation_rad2, 0.);
}

// On drives with such errors the end must be about as wrong as expected: within a factor of two,
// since directions are not told apart.
TEST(OdometryUncertaintyTest, IsAboutTheErrorOfManyDrives) {
  constexpr int kDrives = 300;
  const auto options = Options("0.02, 0.02, 0.05, 0.05", "0, 0, 0, 0");
  const Poses truth = Laps(0.8);
  Graph graph;
  AddTrajectory(0, truth, &graph);
  const OdometryUncertainty uncertainty(options, OdometryChain(options, graph, 0));
  const int end = static_cast<int>(truth.size()) - 1;
  double sum_m2 = 0.;
  for (int i = 0; i < kDrives; ++i) {
    OdometryErrors errors;
    errors.sigmas_per_sqrt_m = ToTwist(options.random());
    errors.seed = i;
    const Poses odometry = WithErrors(truth, errors);
    sum_m2 += (odometry[end].translation() - truth[end].translation()).squaredNorm() / 3.;
  }
  const double ratio = uncertainty.Between(0, end).translation_m2 / (sum_m2 / kDrives);
  EXPECT_GT(ratio, 0.5);
  EXPECT_LT(ratio, 2.);
}

}  // namespace
}  // namespace cartographer::pose_graph
