// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/ground_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "semantic_kiss/simulation/random.h"
#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kReach_m = 60.;

class GroundProfileTest : public ::testing::Test {
 protected:
  void Look(double azimuth) {
    const PlanarPose& pose = drive_->route().poses[20];
    origin_ << pose.position, ground_.Height(pose.position) + 1.73;
    heading_ << std::cos(azimuth), std::sin(azimuth);
    profile_.Take(origin_, heading_);
  }

  const std::unique_ptr<Simulation> drive_ = SmallDrive("options.world.hill_height_m = 6.");
  const Ground& ground_ = drive_->world().ground();
  GroundProfile profile_{ground_, kReach_m};
  Eigen::Vector3d origin_;
  Eigen::Vector2d heading_;
};

TEST_F(GroundProfileTest, RaysStayAboveTheGroundForThatLong) {
  int met = 0;
  double saved_m = 0.;
  for (double azimuth = 0.; azimuth < 6.2; azimuth += 0.13) {
    Look(azimuth);
    for (double slope = -0.45; slope < 0.1; slope += 0.03) {
      // The oracle walks along the ray in steps of a centimetre.
      double walked_m = 0.;
      const auto above = [&](double distance_m) {
        return origin_.z() + slope * distance_m >
               ground_.Height(origin_.head<2>() + distance_m * heading_);
      };
      while (walked_m < kReach_m && above(walked_m)) walked_m += 0.01;
      const double clear_m = profile_.ClearUntil(slope);
      if (walked_m >= kReach_m) continue;
      ++met;
      EXPECT_LE(clear_m, walked_m) << "azimuth " << azimuth << ", slope " << slope;
      saved_m += std::isfinite(clear_m) ? clear_m / walked_m : 0.;
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(saved_m / met, 0.8) << "nothing is gained";
}

TEST_F(GroundProfileTest, UpwardRaysAreClearAndSteepOnesMeetAtOnce) {
  Look(1.);
  EXPECT_EQ(profile_.ClearUntil(0.5), std::numeric_limits<double>::infinity());
  EXPECT_EQ(profile_.ClearUntil(-1e3), 0.);
}

}  // namespace
}  // namespace semantic_kiss::simulation
