// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/adaptive_threshold.h"

#include <gtest/gtest.h>

#include <cmath>

namespace semantic_kiss::odometry {
namespace {

using cartographer::transform::Rigid3d;

proto::AdaptiveThresholdOptions Options() {
  proto::AdaptiveThresholdOptions options;
  options.set_initial_m(2.);
  options.set_min_model_error_m(0.1);
  options.set_gate_sigmas(3.);
  options.set_kernel_sigmas(1.);
  options.set_initial_samples(1);
  return options;
}

TEST(AdaptiveThresholdTest, StartsWithTheInitialValue) {
  const AdaptiveThreshold threshold(Options(), 100.);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), 2.);
  EXPECT_DOUBLE_EQ(threshold.Gate(), 6.);
  EXPECT_DOUBLE_EQ(threshold.KernelScale(), 2.);
}

TEST(AdaptiveThresholdTest, SigmaIsTheRootMeanSquareOfTheErrors) {
  AdaptiveThreshold threshold(Options(), 100.);
  threshold.Observe(Rigid3d::Translation({0.3, 0.4, 0.}), 1.);  // 0.5 m
  threshold.Observe(Rigid3d::Translation({0., 0., 0.2}), 2.);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), std::sqrt((4. + 0.25 + 0.04) / 3.));
}

TEST(AdaptiveThresholdTest, SmallErrorsTeachNothing) {
  AdaptiveThreshold threshold(Options(), 100.);
  threshold.Observe(Rigid3d::Translation({0.099, 0., 0.}), 1.);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), 2.);
}

TEST(AdaptiveThresholdTest, AsInSageIcpTheInitialValueEndsWithTheFirstErrorOnTheWay) {
  proto::AdaptiveThresholdOptions options = Options();
  options.set_kernel_sigmas(0.5);
  options.set_initial_samples(0);
  options.set_learn_beyond_m(0.5);
  AdaptiveThreshold threshold(options, 100.);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), 2.);
  EXPECT_DOUBLE_EQ(threshold.KernelScale(), 1.);
  threshold.Observe(Rigid3d::Translation({0.3, 0., 0.}), 0.49);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), 2.);
  threshold.Observe(Rigid3d::Translation({0.3, 0., 0.}), 0.5);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), 0.3);
  threshold.Observe(Rigid3d::Translation({0., 0.4, 0.}), 0.9);
  EXPECT_DOUBLE_EQ(threshold.Sigma(), std::sqrt((0.09 + 0.16) / 2.));
}

TEST(AdaptiveThresholdTest, RotationsAreFeltAtTheMaximumRange) {
  const Rigid3d turn =
      Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ())));
  EXPECT_NEAR(ModelError(turn, 100.), 200. * std::sin(0.005), 1e-12);
  EXPECT_NEAR(ModelError(Rigid3d::Translation({1., 0., 0.}) * turn, 100.),
              1. + 200. * std::sin(0.005), 1e-12);
}

}  // namespace
}  // namespace semantic_kiss::odometry
