// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/traffic.h"

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/synthetic_routes.h"
#include "semantic_kiss/simulation/things.h"

namespace semantic_kiss::simulation {
namespace {

// Half of the length of way over which an actor is there.
constexpr double kSight_m = 100.;
constexpr double kOppositeLane_m = 3.5;

}  // namespace

Traffic::Traffic(const Route& route, const StreetMap& streets, double density, double scan_rate_hz,
                 uint64_t seed, int epoch)
    : route_(route),
      scan_rate_hz_(scan_rate_hz),
      key_(
          HashKey({seed, static_cast<uint64_t>(Purpose::kTraffic), static_cast<uint64_t>(epoch)})) {
  way_m_.assign(1, 0.);
  for (size_t i = 1; i < route.poses.size(); ++i) {
    way_m_.push_back(way_m_.back() +
                     (route.poses[i].position - route.poses[i - 1].position).norm());
  }
  if (density <= 0.) return;
  AddVehicles(density, key_);
  AddWalkersAndCyclists(streets, density, key_ + 1);
}

void Traffic::AddVehicles(double density, uint64_t key) {
  Random random(key);
  for (double way_m = 20.; way_m < way_m_.back();) {
    const double scan = ScanAtWay(way_m);
    const bool highway = route_.on_highway[static_cast<size_t>(scan)];
    const Kind kind = random.Chance(highway ? 0.2 : 0.06) ? Kind::kTruck : Kind::kCar;
    const double speed = highway ? random.Uniform(23., 33.) : random.Uniform(7., 13.);
    const double pick = random.Uniform();
    if (pick < 0.25) {
      actors_.push_back(
          {kind, scan, way_m, 0., 0., random.Uniform(50., 200.), random.Uniform(14., 35.)});
    } else if (highway && pick < 0.5) {
      actors_.push_back({kind, scan, way_m, SpeedAt(scan) + random.Uniform(3., 8.), 3.6, 120., 0.});
    } else {
      const double left_m = highway ? random.Uniform() < 0.5 ? 17.2 : 13.6 : kOppositeLane_m;
      const double lasts = kSight_m / (speed + SpeedAt(scan)) * scan_rate_hz_;
      actors_.push_back({kind, scan, way_m, -speed, left_m, lasts, 0.});
    }
    way_m += random.Uniform(40., 160.) * (highway ? 1.5 : 1.) / density;
  }
}

void Traffic::AddWalkersAndCyclists(const StreetMap& streets, double density, uint64_t key) {
  Random random(key);
  for (double way_m = 10.; way_m < way_m_.back();) {
    const double scan = ScanAtWay(way_m);
    way_m += random.Uniform(15., 90.) / density;
    const PlanarPose pose = PoseOnWay(way_m);
    const StreetMap::Place place = streets.Find(pose.position + kLaneOffset_m * pose.Left());
    if (route_.on_highway[static_cast<size_t>(scan)] || place.nearest < 0) continue;
    const StreetSection& section = streets.centres()[place.nearest].section;
    if (random.Chance(0.2)) {
      actors_.push_back({Kind::kCyclist, scan, way_m, random.Uniform(3.5, 6.), -1.75, 120., 0.});
      continue;
    }
    const bool left = random.Chance(0.5);
    const double from_middle_m = section.half_width_m +
                                 std::max(section.parking_m[0], section.parking_m[1]) +
                                 random.Uniform(0.7, 1.8);
    const double speed = random.Uniform(0.8, 1.7) * (random.Chance(0.5) ? 1. : -1.);
    actors_.push_back({Kind::kPedestrian, scan, way_m, speed,
                       kLaneOffset_m + (left ? from_middle_m : -from_middle_m), 200., 0.});
  }
}

double Traffic::WayAt(double scan) const {
  const double last = static_cast<double>(way_m_.size() - 1);
  const double clamped = std::clamp(scan, 0., last);
  const size_t i = std::min(static_cast<size_t>(clamped), way_m_.size() - 2);
  return way_m_[i] + (clamped - i) * (way_m_[i + 1] - way_m_[i]);
}

double Traffic::ScanAtWay(double way_m) const {
  const auto after = std::upper_bound(way_m_.begin(), way_m_.end(), way_m);
  if (after == way_m_.begin()) return 0.;
  if (after == way_m_.end()) return static_cast<double>(way_m_.size() - 1);
  const size_t i = after - way_m_.begin() - 1;
  return i + (way_m - way_m_[i]) / (way_m_[i + 1] - way_m_[i]);
}

double Traffic::SpeedAt(double scan) const {
  return (WayAt(scan + 1.) - WayAt(scan - 1.)) * 0.5 * scan_rate_hz_;
}

PlanarPose Traffic::PoseOnWay(double way_m) const {
  const double scan = ScanAtWay(way_m);
  const size_t i = std::min(static_cast<size_t>(scan), route_.poses.size() - 2);
  const PlanarPose& a = route_.poses[i];
  const PlanarPose& b = route_.poses[i + 1];
  const double t = scan - i;
  return {a.position + t * (b.position - a.position), a.yaw + t * (b.yaw - a.yaw)};
}

double Traffic::WayOf(const Actor& actor, double scan) const {
  const double since = scan - actor.met_at_scan;
  if (actor.ahead_m > 0.) {
    return since < 0. || since > 2. * actor.lasts_scans ? -1. : WayAt(scan) + actor.ahead_m;
  }
  if (std::abs(since) > actor.lasts_scans) return -1.;
  return actor.met_at_way_m + actor.speed_m_per_s * since / scan_rate_hz_;
}

std::vector<MovingThing> Traffic::At(double scan, double reach_m, const Ground& ground) const {
  std::vector<MovingThing> things;
  const Eigen::Vector2d here = PoseOnWay(WayAt(scan)).position;
  for (size_t k = 0; k < actors_.size(); ++k) {
    const Actor& actor = actors_[k];
    const double way_m = WayOf(actor, scan);
    if (way_m < 0. || way_m > way_m_.back()) continue;
    const PlanarPose pose = PoseOnWay(way_m);
    const Eigen::Vector2d position = pose.position + actor.left_m * pose.Left();
    if ((position - here).norm() > reach_m) continue;
    const double speed = actor.ahead_m > 0. ? SpeedAt(scan) : actor.speed_m_per_s;
    const Stand stand{{position.x(), position.y(), ground.Height(position)},
                      pose.yaw + (speed < 0. ? M_PI : 0.),
                      kFirstObject + static_cast<uint32_t>(k)};
    const Random random(HashKey({key_, k}));
    MovingThing thing;
    thing.pieces = actor.kind == Kind::kCar       ? MakeCar(stand, true, random)
                   : actor.kind == Kind::kTruck   ? MakeTruck(stand, true, random)
                   : actor.kind == Kind::kCyclist ? MakeCyclist(stand, true, random)
                                                  : MakePerson(stand, true, random);
    thing.velocity << speed * pose.Forward(), 0.;
    thing.centre = position;
    things.push_back(std::move(thing));
  }
  return things;
}

}  // namespace semantic_kiss::simulation
