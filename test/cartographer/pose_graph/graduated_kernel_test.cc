// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graduated_kernel.h"

#include <gtest/gtest.h>

namespace cartographer::pose_graph {
namespace {

TEST(GraduatedKernelTest, WeightIsTwiceTheSlopeOfTheCost) {
  GraduatedKernel kernel(9.);
  kernel.Narrow({1.});
  ASSERT_TRUE(kernel.IsFinal());
  for (const double error : {0.1, 1., 9., 100.}) {
    const double step = 1e-5 * error;
    EXPECT_NEAR(kernel.Weight(error),
                2. * (kernel.Cost(error + step) - kernel.Cost(error - step)) / (2. * step), 1e-8);
  }
}

TEST(GraduatedKernelTest, CostIsThatOfASpringWhereSmallAndBounded) {
  const GraduatedKernel kernel(9.);
  EXPECT_EQ(kernel.Cost(0.), 0.);
  EXPECT_NEAR(kernel.Cost(1e-6), 0.5e-6, 1e-12);
  EXPECT_LT(kernel.Cost(1e12), 4.5);
}

TEST(GraduatedKernelTest, PullsAQuarterAtItsScale) {
  GraduatedKernel kernel(9.);
  kernel.Narrow({0.});
  EXPECT_EQ(kernel.Weight(0.), 1.);
  EXPECT_EQ(kernel.Weight(9.), 0.25);
}

TEST(GraduatedKernelTest, BeginsWideAndNarrowsToTheEnd) {
  GraduatedKernel kernel(9.);
  EXPECT_FALSE(kernel.IsFinal());
  const double outlier = 9. * 1000.;
  kernel.Narrow({1., outlier});
  // Twice as wide as the largest error: all pull.
  EXPECT_NEAR(kernel.Weight(outlier), 4. / 9., 1e-12);
  int widths = 1;
  for (double last = kernel.Weight(outlier); !kernel.IsFinal(); ++widths) {
    kernel.Narrow({1., outlier});
    EXPECT_LT(kernel.Weight(outlier), last);
    last = kernel.Weight(outlier);
  }
  EXPECT_EQ(widths, 7);  // from 2000 by quarters to 1
  EXPECT_LT(kernel.Weight(outlier), 1e-5);
}

TEST(GraduatedKernelTest, IsNarrowAtOnceIfNothingIsFarOff) {
  GraduatedKernel kernel(9.);
  kernel.Narrow({1., 2.});
  EXPECT_TRUE(kernel.IsFinal());
}

TEST(GraduatedKernelTest, SkipsWidthsThatTheErrorsNoLongerNeed) {
  GraduatedKernel kernel(9.);
  kernel.Narrow({9000.});
  EXPECT_FALSE(kernel.IsFinal());
  kernel.Narrow({3.});
  EXPECT_TRUE(kernel.IsFinal());
}

}  // namespace
}  // namespace cartographer::pose_graph
