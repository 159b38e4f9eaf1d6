// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_STREET_MAP_H_
#define SEMANTIC_KISS_SIMULATION_STREET_MAP_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <utility>
#include <vector>

#include "semantic_kiss/simulation/route.h"
#include "semantic_kiss/simulation/sparse_raster.h"

namespace semantic_kiss::simulation {

// What a street looks like at one point of its centre line. Sides: 0 left, 1 right.
struct StreetSection {
  double half_width_m = 4.;        // from the centre line to the edge of the carriageway
  double parking_m[2] = {0., 0.};  // strip for parked cars beside the carriageway
  double sidewalk_m = 2.;          // beyond the parking strip
  double kerb_m = 0.12;            // height of the sidewalk and of what lies behind it
  bool highway = false;
};

struct CentrePoint {
  PlanarPose pose;
  double arc_m = 0.;  // along its street
  int order = -1;     // along the drive, in points; -1: not driven
  bool bend = false;  // turns sharply here, as at crossings
  StreetSection section;
};

// Parts of the plane that differ from what the distance to the street says.
enum class Cover : uint8_t { kByStreet, kLot, kYard };

// The streets seen from above. Where anything may stand is decided by two distances: from the
// edge of the carriageways and from the line that the lidar drives.
class StreetMap {
 public:
  // Both distances are exact up to this value and clamped there.
  static constexpr double kReach_m = 30.;

  // `margin_m`: side streets are kept up to this distance from the route.
  StreetMap(const Route& route, double margin_m, uint64_t seed);

  // What is known about a point of the plane.
  struct Place {
    double outside_m;  // from the edge of the carriageway, negative on it
    int nearest;       // index of the nearest centre point, -1 if none is within reach
    int side;          // of that point's street: 0 left, 1 right
    double across_m;   // distance from the centre line
    Cover cover;
  };
  Place Find(const Eigen::Vector2d& position) const;

  // The first column of Place alone, and the distance from the driven line.
  double Outside(const Eigen::Vector2d& position) const;
  double Clearance(const Eigen::Vector2d& position) const;

  void SetCover(const Eigen::Vector2d& position, Cover cover);

  const std::vector<CentrePoint>& centres() const { return centres_; }
  // [first, last) of each unbroken centre line.
  const std::vector<std::pair<size_t, size_t>>& streets() const { return streets_; }
  // Around everything that may be built.
  const Eigen::AlignedBox2d& bounds() const { return bounds_; }

 private:
  struct Node {
    float outside_m = kReach_m;
    float clearance_m = kReach_m;
    int32_t nearest = -1;
    Cover cover = Cover::kByStreet;
  };

  // Adds a point to the last street if that goes on, else begins another one.
  void Append(const StreetPoint& point, int order, bool goes_on, uint64_t seed);
  void AddSideStreet(const std::vector<StreetPoint>& points, uint64_t seed);
  void AddDrivenStreets(const Route& route, uint64_t seed);
  // Whether the point lies on a street that is stamped already.
  bool IsKnownStreet(const StreetPoint& point) const;
  void StampSection(size_t index);
  void StampDriven(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  Eigen::AlignedBox2d bounds_;
  SparseRaster<Node> nodes_;
  std::vector<CentrePoint> centres_;
  std::vector<std::pair<size_t, size_t>> streets_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_STREET_MAP_H_
