// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SITE_H_
#define SEMANTIC_KISS_SIMULATION_SITE_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/ground.h"
#include "semantic_kiss/simulation/hills.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/sparse_raster.h"
#include "semantic_kiss/simulation/street_map.h"
#include "semantic_kiss/simulation/things.h"

namespace semantic_kiss::simulation {

// A rectangle on the ground.
struct Footprint {
  Eigen::Vector2d centre;
  double yaw = 0.;
  double half_length_m = 0.5, half_width_m = 0.5;

  // A point of it; u and v in [-1, 1].
  Eigen::Vector2d At(double u, double v) const;
};

// Room that a thing needs.
struct Room {
  double outside_m = 0.;     // from the carriageways
  double clearance_m = 1.7;  // from the line that the lidar drives
};

// A side of a street, for walking along it.
struct Kerbside {
  const CentrePoint* centre;
  int side;  // 0 left, 1 right

  double sign() const { return side == 0 ? 1. : -1.; }
  // `outside_m` beyond the carriageway's edge.
  Eigen::Vector2d At(double outside_m) const;
  double Sidewalk() const { return centre->section.parking_m[side]; }
  double Property() const { return Sidewalk() + centre->section.sidewalk_m; }
  double Yaw() const { return centre->pose.yaw; }
  // Heading of the traffic on this side.
  double TrafficYaw() const;
  // From this side towards the street.
  double InwardYaw() const;
};

// The town while it is built: who owns which piece of ground, and what stands so far.
// Numbers of objects do not depend on the epoch: static things and places for movable ones are
// counted apart.
class Site {
 public:
  Site(const proto::WorldOptions& options, uint64_t seed, int epoch, StreetMap* streets);

  bool IsFree(const Footprint& footprint, const Room& room) const;
  void Occupy(const Footprint& footprint);

  // Number for the next static thing, or for the next place of a movable one.
  uint32_t NextStatic() { return ++static_objects_; }
  uint32_t NextMovable() { return kFirstMovable + ++movable_objects_; }

  void Add(const std::vector<Primitive>& pieces);
  // A stand on the ground.
  Stand StandAt(const Eigen::Vector2d& position, double yaw, uint32_t object) const;

  const proto::WorldOptions& options;
  const uint64_t seed;
  const int epoch;
  StreetMap& streets;
  const Ground* ground = nullptr;  // from Build() on
  std::vector<Primitive> primitives;

  static constexpr uint32_t kFirstMovable = 1u << 30;

 private:
  SparseRaster<uint8_t> taken_;
  uint32_t static_objects_ = 0, movable_objects_ = 0;
};

// Walks along every street, once per side, and calls visit(kerbside, random) which returns the
// distance to the next call [m]. `random` belongs to the purpose, the errand (several may share a
// purpose), the street and the side.
template <typename Visit>
void WalkKerbs(const Site& site, Purpose purpose, uint64_t errand, const Visit& visit) {
  const auto& streets = site.streets.streets();
  for (size_t street = 0; street < streets.size(); ++street) {
    for (int side : {0, 1}) {
      Random random(site.seed, purpose, street, 2 * errand + side);
      double next_m = random.Uniform(0., 5.);
      for (size_t i = streets[street].first; i < streets[street].second; ++i) {
        const CentrePoint& centre = site.streets.centres()[i];
        if (centre.arc_m < next_m) continue;
        next_m = centre.arc_m + visit(Kerbside{&centre, side}, random);
      }
    }
  }
}

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SITE_H_
