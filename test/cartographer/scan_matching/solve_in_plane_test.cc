// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/solve_in_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cartographer::scan_matching {
namespace {

// Three residuals, zero at a pose that is known.
class KnownMinimum : public PlanarResiduals {
 public:
  explicit KnownMinimum(double scale) : scale_(scale) {}
  int size() const override { return 3; }
  void Evaluate(const PlanarPose& pose, double* residuals, double* jacobian) const override {
    residuals[0] = scale_ * (pose.translation.x() - 3.);
    residuals[1] = scale_ * (pose.translation.y() + 1.);
    residuals[2] = scale_ * (pose.yaw_rad - 4.);
    if (jacobian == nullptr) return;
    for (int i = 0; i < 9; ++i) jacobian[i] = i % 4 == 0 ? scale_ : 0.;
  }

 private:
  const double scale_;
};

TEST(SolveInPlaneTest, FindsTheMinimum) {
  const PlanarSolution solution = SolveInPlane(KnownMinimum(2.), {{0., 0.}, 3.}, 50, 1e-12);
  EXPECT_TRUE(solution.usable);
  EXPECT_NEAR(solution.pose.translation.x(), 3., 1e-6);
  EXPECT_NEAR(solution.pose.translation.y(), -1., 1e-6);
  EXPECT_NEAR(solution.pose.yaw_rad, 4. - 2. * M_PI, 1e-6);
  EXPECT_DOUBLE_EQ(solution.initial_cost, 0.5 * 4. * (9. + 1. + 1.));
  EXPECT_NEAR(solution.final_cost, 0., 1e-9);
}

TEST(SolveInPlaneTest, WhatIsNotFiniteIsNotUsable) {
  const KnownMinimum broken(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(SolveInPlane(broken, {}, 50, 1e-6).usable);
}

}  // namespace
}  // namespace cartographer::scan_matching
