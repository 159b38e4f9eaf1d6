// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_TRAFFIC_H_
#define SEMANTIC_KISS_SIMULATION_TRAFFIC_H_

#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/ground.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"
#include "semantic_kiss/simulation/street_map.h"

namespace semantic_kiss::simulation {

// Something in motion, as it is in the middle of a sweep.
struct MovingThing {
  std::vector<Primitive> pieces;
  Eigen::Vector3d velocity;  // [m/s], world frame
  Eigen::Vector2d centre;    // seen from above
};

// Cars, cyclists and pedestrians that the drive meets: they follow the route's line at a sideways
// offset, with it or against it. A function of seed and epoch.
class Traffic {
 public:
  // `route`, `streets` must outlive it.
  Traffic(const Route& route, const StreetMap& streets, double density, double scan_rate_hz,
          uint64_t seed, int epoch);

  // What is within `reach_m` of the car at `scan` (fractions: between scans).
  std::vector<MovingThing> At(double scan, double reach_m, const Ground& ground) const;

  static constexpr uint32_t kFirstObject = 3u << 30;

 private:
  enum class Kind { kCar, kTruck, kCyclist, kPedestrian };
  struct Actor {
    Kind kind;
    double met_at_scan;    // when it is abreast of the car, or, of a car ahead, first seen
    double met_at_way_m;   // where along the route
    double speed_m_per_s;  // along the route, negative against it
    double left_m;         // from the route's line
    double lasts_scans;    // present this long before and after
    double ahead_m;        // > 0: keeps this distance ahead of the car instead
  };

  void AddVehicles(double density, uint64_t key);
  void AddWalkersAndCyclists(const StreetMap& streets, double density, uint64_t key);
  double WayAt(double scan) const;
  double ScanAtWay(double way_m) const;
  double SpeedAt(double scan) const;
  PlanarPose PoseOnWay(double way_m) const;
  // Of the actor along the route; negative: absent.
  double WayOf(const Actor& actor, double scan) const;

  const Route& route_;
  const double scan_rate_hz_;
  const uint64_t key_;
  std::vector<double> way_m_;  // driven up to each scan
  std::vector<Actor> actors_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_TRAFFIC_H_
