// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/synthetic_routes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "semantic_kiss/simulation/path.h"
#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

// Crossings of the net; the drive stays within this distance of (0, 0) along either axis.
constexpr int kNetRadius = 3;
constexpr double kBlockAspect = 0.7;  // blocks are longer than they are deep
constexpr double kCrossingJitter_m = 7.;
constexpr double kRightTurnRadius_m = 6.5;
constexpr double kLeftTurnRadius_m = 10.;
constexpr double kBendRadius_m = 60.;

struct Crossing {
  int column = 0, row = 0;
};

class StreetNet {
 public:
  StreetNet(double block_m, uint64_t seed) : block_m_(block_m), seed_(seed) {}

  Eigen::Vector2d Position(const Crossing& crossing) const {
    Random random(seed_, Purpose::kStreet, static_cast<uint64_t>(crossing.column + 1000),
                  static_cast<uint64_t>(crossing.row + 1000));
    return Eigen::Vector2d(
        crossing.column * block_m_ + random.Uniform(-kCrossingJitter_m, kCrossingJitter_m),
        crossing.row * block_m_ * kBlockAspect +
            random.Uniform(-kCrossingJitter_m, kCrossingJitter_m));
  }

 private:
  double block_m_;
  uint64_t seed_;
};

Crossing Step(const Crossing& from, char direction) {
  switch (direction) {
    case 'E':
      return {from.column + 1, from.row};
    case 'N':
      return {from.column, from.row + 1};
    case 'W':
      return {from.column - 1, from.row};
    default:
      return {from.column, from.row - 1};
  }
}

// Where to go at each crossing.
class Tour {
 public:
  explicit Tour(uint64_t seed) : random_(seed, Purpose::kRoute) {}

  Crossing Next(const Crossing& at) {
    static const std::string kOpening = "ENWSEENWSW";
    if (step_ < kOpening.size()) {
      last_ = kOpening[step_++];
      return Step(at, last_);
    }
    static const std::string kDirections = "ENWS";
    while (true) {
      const int choice = random_.Index(4);
      const char direction = kDirections[choice];
      const Crossing next = Step(at, direction);
      const bool turns_back = kDirections[(choice + 2) % 4] == last_;
      const bool leaves = std::abs(next.column) > kNetRadius || std::abs(next.row) > kNetRadius;
      if (turns_back || leaves) continue;
      last_ = direction;
      return next;
    }
  }

 private:
  Random random_;
  size_t step_ = 0;
  char last_ = 'E';
};

Eigen::Vector2d RightOf(const Eigen::Vector2d& direction) {
  return Eigen::Vector2d(direction.y(), -direction.x());
}

// The crossings' corners as seen from the right-hand lane.
std::vector<Corner> LaneCorners(const std::vector<Eigen::Vector2d>& crossings) {
  std::vector<Corner> corners;
  for (size_t i = 0; i < crossings.size(); ++i) {
    const Eigen::Vector2d in =
        (i > 0 ? crossings[i] - crossings[i - 1] : crossings[1] - crossings[0]).normalized();
    const Eigen::Vector2d out =
        (i + 1 < crossings.size() ? crossings[i + 1] - crossings[i] : in).normalized();
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    const Eigen::Vector2d bisector = (RightOf(in) + RightOf(out)).normalized();
    const Eigen::Vector2d position = crossings[i] + kLaneOffset_m / std::cos(0.5 * turn) * bisector;
    const bool sharp = std::abs(turn) > 0.6;
    const double radius_m =
        !sharp ? kBendRadius_m : (turn < 0. ? kRightTurnRadius_m : kLeftTurnRadius_m);
    corners.push_back({position, radius_m});
  }
  return corners;
}

std::vector<StreetPoint> StraightStreet(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const std::vector<PathPoint> path = RoundedPath({{from, 0.}, {to, 0.}});
  std::vector<StreetPoint> street;
  for (size_t i = 0; i < path.size(); i += 4) street.push_back({path[i].pose, false});
  return street;
}

std::vector<std::vector<StreetPoint>> AllStreets(const StreetNet& net) {
  constexpr int kReach = kNetRadius + 1;
  std::vector<std::vector<StreetPoint>> streets;
  for (int column = -kReach; column <= kReach; ++column) {
    for (int row = -kReach; row <= kReach; ++row) {
      const Crossing here{column, row};
      for (const char direction : {'E', 'N'}) {
        const Crossing there = Step(here, direction);
        if (there.column > kReach || there.row > kReach) continue;
        streets.push_back(StraightStreet(net.Position(here), net.Position(there)));
      }
    }
  }
  return streets;
}

Route RouteAlong(std::vector<PathPoint> path, const SpeedLimits& limits, double length_m,
                 double scan_rate_hz, bool highway) {
  const size_t points = static_cast<size_t>(length_m / kPathStep_m) + 2;
  if (path.size() > points) path.resize(points);
  Route route;
  route.poses = DrivePath(path, limits, scan_rate_hz);
  route.on_highway.assign(route.poses.size(), highway);
  return route;
}

SpeedLimits Limits(const proto::RouteOptions& options, double cruise_m_per_s) {
  return {cruise_m_per_s, options.lateral_acceleration_m_per_s2(), options.acceleration_m_per_s2()};
}

}  // namespace

Route MakeCityRoute(const proto::RouteOptions& options, double scan_rate_hz, uint64_t seed) {
  const StreetNet net(options.block_m(), seed);
  Tour tour(seed);
  Crossing at;
  std::vector<Eigen::Vector2d> crossings = {net.Position(at)};
  double planned_m = 0.;
  while (planned_m < options.length_m() + 4. * options.block_m()) {
    at = tour.Next(at);
    crossings.push_back(net.Position(at));
    planned_m += (crossings.back() - crossings[crossings.size() - 2]).norm();
  }
  Route route =
      RouteAlong(RoundedPath(LaneCorners(crossings)), Limits(options, options.city_speed_m_per_s()),
                 options.length_m(), scan_rate_hz, false);
  route.side_streets = AllStreets(net);
  return route;
}

Route MakeHighwayRoute(const proto::RouteOptions& options, double scan_rate_hz, uint64_t seed) {
  constexpr double kRadius_m = 700.;
  Random random(seed, Purpose::kRoute);
  std::vector<Corner> corners = {{Eigen::Vector2d::Zero(), kRadius_m}};
  double heading = 0.;
  for (double planned_m = 0.; planned_m < options.length_m() + 1000.;) {
    const double leg_m = random.Uniform(350., 700.);
    corners.push_back(
        {corners.back().position + leg_m * Eigen::Vector2d(std::cos(heading), std::sin(heading)),
         kRadius_m});
    heading += random.Uniform(-0.4, 0.4) - 0.3 * heading;
    planned_m += leg_m;
  }
  return RouteAlong(RoundedPath(corners), Limits(options, options.highway_speed_m_per_s()),
                    options.length_m(), scan_rate_hz, true);
}

Route MakeLoopRoute(const proto::RouteOptions& options, double scan_rate_hz, uint64_t seed) {
  constexpr int kCorners = 10;
  Random random(seed, Purpose::kRoute);
  const double radius_m = options.ring_m() / (2. * M_PI);
  std::vector<Corner> ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2. * M_PI * (i + random.Uniform(-0.2, 0.2)) / kCorners;
    const double stretch = random.Uniform(0.8, 1.2);
    ring.push_back(
        {stretch * radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 0.6 * radius_m});
  }
  std::vector<Corner> corners;
  const int laps = 2 + static_cast<int>(options.length_m() / (0.8 * options.ring_m()));
  for (int i = 0; i < laps * kCorners; ++i) corners.push_back(ring[i % kCorners]);
  return RouteAlong(RoundedPath(corners), Limits(options, options.city_speed_m_per_s()),
                    options.length_m(), scan_rate_hz, false);
}

}  // namespace semantic_kiss::simulation
