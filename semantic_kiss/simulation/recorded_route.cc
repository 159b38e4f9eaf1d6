// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/recorded_route.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/slope_limit.h"

namespace semantic_kiss::simulation {
namespace {

using cartographer::transform::Rigid3d;

// Speed is judged over this time on either side of a scan.
constexpr double kSpeedWindow_s = 4.;
constexpr double kSideStreet_m = 70.;
constexpr double kLeftToStreetMiddle_m = 1.8;

std::vector<bool> FindHighway(const std::vector<PlanarPose>& poses, double threshold_m_per_s,
                              double rate_hz) {
  const int window = std::max(1, static_cast<int>(kSpeedWindow_s * rate_hz));
  const int size = static_cast<int>(poses.size());
  std::vector<bool> on_highway(size);
  for (int i = 0; i < size; ++i) {
    const int first = std::max(0, i - window);
    const int last = std::min(size - 1, i + window);
    const double distance_m = (poses[last].position - poses[first].position).norm();
    on_highway[i] = distance_m * rate_hz > threshold_m_per_s * (last - first);
  }
  return on_highway;
}

// Poses about a metre apart, each with the scan it comes from.
std::vector<size_t> Thin(const std::vector<PlanarPose>& poses) {
  std::vector<size_t> kept = {0};
  for (size_t i = 1; i < poses.size(); ++i) {
    if ((poses[i].position - poses[kept.back()].position).norm() > 1.) kept.push_back(i);
  }
  return kept;
}

class SideStreetGuesser {
 public:
  SideStreetGuesser(Route* route, uint64_t seed)
      : route_(*route), kept_(Thin(route->poses)), random_(seed, Purpose::kRoute) {}

  void Guess() {
    constexpr int kReach = 12;  // kept poses, so metres or a little more, around a turn
    double next_at = random_.Uniform(30., 90.);
    for (int i = kReach; i + kReach < static_cast<int>(kept_.size()); ++i) {
      const PlanarPose& before = route_.poses[kept_[i - kReach]];
      const PlanarPose& after = route_.poses[kept_[i + kReach]];
      if (route_.on_highway[kept_[i]]) continue;
      if (std::abs(after.yaw - before.yaw) > 0.9 && i > turn_over_) {
        turn_over_ = i + 3 * kReach;
        AddStraight(before, before.yaw);
        AddStraight(after, after.yaw + M_PI);
      } else if (i > next_at) {
        next_at = i + random_.Uniform(60., 160.);
        const double side = random_.Chance(0.5) ? 1. : -1.;
        AddStraight(route_.poses[kept_[i]],
                    route_.poses[kept_[i]].yaw + side * random_.Uniform(1.2, 1.9));
      }
    }
  }

 private:
  // A street from the middle of the driven one until it comes near another part of the route.
  void AddStraight(const PlanarPose& from, double yaw) {
    const Eigen::Vector2d start = from.position + kLeftToStreetMiddle_m * from.Left();
    std::vector<StreetPoint> street;
    for (double s = 0.; s < kSideStreet_m; s += 1.) {
      const PlanarPose pose{start + s * Eigen::Vector2d(std::cos(yaw), std::sin(yaw)), yaw};
      if (s > 25. && NearRoute(pose.position, 18.)) break;
      street.push_back({pose, false});
    }
    route_.side_streets.push_back(std::move(street));
  }

  bool NearRoute(const Eigen::Vector2d& position, double distance_m) const {
    return std::any_of(kept_.begin(), kept_.end(), [&](size_t index) {
      return (route_.poses[index].position - position).squaredNorm() < distance_m * distance_m;
    });
  }

  Route& route_;
  const std::vector<size_t> kept_;
  Random random_;
  int turn_over_ = 0;
};

}  // namespace

Rigid3d CameraFromLidar() {
  Eigen::Matrix<double, 3, 4> matrix;
  matrix << -0.0019, -1., -0.0080, -0.0048,  //
      -0.0065, 0.0080, -1., -0.0734,         //
      1., -0.0018, -0.0065, -0.3340;
  return Rigid3d::FromMatrix(matrix);
}

absl::StatusOr<Route> ReadRecordedRoute(const proto::RouteOptions& options, double scan_rate_hz,
                                        uint64_t seed) {
  ASSIGN_OR_RETURN(const std::vector<Rigid3d> camera_poses,
                   cartographer::io::ReadKittiPoses(options.poses_file()));
  const std::vector<Rigid3d> lidar_poses =
      cartographer::io::PosesOfOtherBody(camera_poses, CameraFromLidar().inverse());
  Route route;
  double yaw = 0.;
  for (const Rigid3d& pose : lidar_poses) {
    yaw += std::remainder(cartographer::transform::Yaw(pose.rotation()) - yaw, 2. * M_PI);
    route.poses.push_back({pose.translation().head<2>(), yaw});
    route.heights_m.push_back(pose.translation().z());
  }
  if (Thin(route.poses).size() < 3) {
    return absl::InvalidArgumentError(
        absl::StrCat(options.poses_file(), ": ", route.poses.size(),
                     " poses that move less than 2 m make no route; give a longer drive"));
  }
  route.heights_m = LimitSlopes(route.poses, route.heights_m, options.max_slope());
  route.on_highway = FindHighway(route.poses, options.highway_threshold_m_per_s(), scan_rate_hz);
  SideStreetGuesser(&route, seed).Guess();
  return route;
}

}  // namespace semantic_kiss::simulation
