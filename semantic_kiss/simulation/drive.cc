// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/drive.h"

#include <algorithm>
#include <cmath>

#include "cartographer/transform/se3.h"
#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

using cartographer::transform::Exp;
using cartographer::transform::Rigid3d;
using cartographer::transform::Twist;

constexpr double kHalfWheelbase_m = 1.35;
constexpr double kHalfTrack_m = 0.75;
// The springs answer to bumps over this length of way.
constexpr double kBump_m = 5.;

Rigid3d StandOnHills(const PlanarPose& pose, const Hills& hills, double mount_height_m) {
  const auto height = [&](const Eigen::Vector2d& offset) {
    return hills.Height(pose.position + offset);
  };
  const Eigen::Vector2d forward = kHalfWheelbase_m * pose.Forward();
  const Eigen::Vector2d left = kHalfTrack_m * pose.Left();
  Eigen::Vector3d x, y;
  x << 2. * forward, height(forward) - height(-forward);
  y << 2. * left, height(left) - height(-left);
  Eigen::Matrix3d axes;
  axes.col(0) = x.normalized();
  axes.col(2) = x.cross(y).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  Eigen::Vector3d position;
  position << pose.position, hills.Height(pose.position) + mount_height_m;
  return Rigid3d(position, Eigen::Quaterniond(axes));
}

}  // namespace

std::vector<Rigid3d> DriveOverHills(const Route& route, const Hills& hills,
                                    const proto::RouteOptions& options, double mount_height_m,
                                    uint64_t seed) {
  const uint64_t key = HashKey({seed, static_cast<uint64_t>(Purpose::kMotion)});
  const double sway_rad = options.sway_deg() * M_PI / 180.;
  std::vector<Rigid3d> poses;
  double way_m = 0.;
  for (size_t i = 0; i < route.poses.size(); ++i) {
    if (i > 0) way_m += (route.poses[i].position - route.poses[i - 1].position).norm();
    const auto bump = [&](int n) {
      return std::clamp(Roughness(key + 10 * n, way_m / kBump_m, 0.), -3., 3.);
    };
    Twist springs = Twist::Zero();
    springs << 0., 0., options.heave_m() * bump(0), sway_rad * bump(1), sway_rad * bump(2), 0.;
    poses.push_back(StandOnHills(route.poses[i], hills, mount_height_m) * Exp(springs));
  }
  return poses;
}

}  // namespace semantic_kiss::simulation
