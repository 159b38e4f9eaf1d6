// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/localization_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

Rigid3d At(double x, double y, double yaw_deg) {
  return Rigid3d({x, y, 0.}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw_deg * M_PI / 180.,
                                                                  Eigen::Vector3d::UnitZ())));
}

// The map is bent: its second place is 3 m and 10 degrees from where it is.
const std::vector<MappedPlace> kPlaces = {{At(0, 0, 0), At(0, 0, 0)},
                                          {At(50, 3, 10), At(50, 0, 0)}};

TEST(LocalizationErrorTest, ABentMapIsNotTheLocalizationsFault) {
  const auto errors = LocalizationErrors(
      kPlaces, {At(50, 1, 20), At(1, 0, 0), At(2, 0, 0)},
      {kPlaces[1].map_from_node * At(0, 1, 20), std::nullopt, At(2.3, 0.4, -1.5)});
  ASSERT_TRUE(errors[0].has_value());
  EXPECT_NEAR(errors[0]->position_m, 0., 1e-9);
  EXPECT_NEAR(errors[0]->heading_deg, 0., 1e-6);
  EXPECT_FALSE(errors[1].has_value());
  EXPECT_NEAR(errors[2]->position_m, 0.5, 1e-9);
  EXPECT_NEAR(errors[2]->heading_deg, 1.5, 1e-6);
  EXPECT_FALSE(errors[2]->WrongPlace());
}

TEST(LocalizationErrorTest, SumsUp) {
  EXPECT_FALSE(Summarize({std::nullopt}).position_median_m.has_value());
  const LocalizationMetrics metrics =
      Summarize({LocalizationError{0.1, 0.2}, std::nullopt, LocalizationError{5., 0.1},
                 LocalizationError{0.3, 7.}});
  EXPECT_EQ(metrics.position_median_m, 0.3);
  EXPECT_EQ(metrics.position_max_m, 5.);
  EXPECT_EQ(metrics.heading_median_deg, 0.2);
  EXPECT_EQ(metrics.wrong_places, 2);
}

}  // namespace
}  // namespace semantic_kiss::evaluation
