// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cartographer/common/parallel.h"
#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kNearNode_m = 0.25;
constexpr double kFarNode_m = 1.;
constexpr double kDetailReach_m = 28.;  // from the carriageway's edge
// Steepest rise that the search for a ray's hit must not jump over.
constexpr double kSteepest = 0.25;
constexpr double kSmallestStep_m = 0.12;
// Of a search that turns out to begin below the ground.
constexpr double kStepBack_m = 1.;
constexpr double kCamber = 0.02;

// Where the sidewalk begins and ends, as distances from the carriageway's edge.
double KerbAt(const StreetSection& section, int side) { return section.parking_m[side]; }
double SidewalkEnd(const StreetSection& section, int side) {
  return section.parking_m[side] + section.sidewalk_m;
}

bool IsMarking(const CentrePoint& centre, double across_m, double outside_m) {
  if (centre.section.highway) {
    // Edge lines, and dashes between the two lanes of either direction.
    const double from_edge_m = -outside_m;
    if (std::abs(from_edge_m - 0.5) < 0.1 || std::abs(across_m - 2.6) < 0.1) return true;
    return std::abs(across_m - 6.8) < 0.08 && std::fmod(centre.arc_m, 12.) < 4.;
  }
  return !centre.bend && across_m < 0.07 && std::fmod(centre.arc_m, 8.) < 4.;
}

}  // namespace

Ground::Ground(const StreetMap& streets, const Hills& hills, const proto::WorldOptions& options,
               uint64_t seed)
    : streets_(streets),
      hills_(hills),
      road_relief_m_(options.road_relief_m()),
      terrain_relief_m_(options.terrain_relief_m()),
      key_(HashKey({seed, static_cast<uint64_t>(Purpose::kRelief)})),
      near_(streets.bounds(), kNearNode_m, std::numeric_limits<float>::quiet_NaN()),
      far_(streets.bounds(), kFarNode_m, std::numeric_limits<float>::quiet_NaN()) {
  Fill(&near_, kDetailReach_m);
  Fill(&far_, std::numeric_limits<double>::infinity());
}

void Ground::Fill(SparseRaster<float>* raster, double reach_m) const {
  constexpr int kTile = SparseRaster<float>::kTile;
  const double node_m = raster->step();
  const Eigen::AlignedBox2d& bounds = streets_.bounds();
  std::vector<Eigen::Vector2i> tiles;
  for (int j = raster->Node(bounds.min().y()) & ~(kTile - 1); j <= raster->Node(bounds.max().y());
       j += kTile) {
    for (int i = raster->Node(bounds.min().x()) & ~(kTile - 1); i <= raster->Node(bounds.max().x());
         i += kTile) {
      const Eigen::Vector2d centre = node_m * Eigen::Vector2d(i + kTile / 2, j + kTile / 2);
      if (streets_.Outside(centre) < reach_m - node_m * kTile) tiles.emplace_back(i, j);
    }
  }
  cartographer::common::ParallelChunks(tiles.size(), 1, [&](size_t tile, size_t) {
    for (int k = 0; k < kTile * kTile; ++k) {
      const Eigen::Vector2i node = tiles[tile] + Eigen::Vector2i(k % kTile, k / kTile);
      const Eigen::Vector2d position = node_m * node.cast<double>();
      if (!bounds.contains(position)) continue;
      raster->MutableAt(node.x(), node.y()) = static_cast<float>(Evaluate(position));
    }
  });
}

double Ground::Evaluate(const Eigen::Vector2d& p) const {
  const StreetMap::Place place = streets_.Find(p);
  const double road = road_relief_m_ * Roughness(key_, p.x() / 2.5, p.y() / 2.5);
  double rough = 1., kerb_m = 0.12, camber_m = 0.;
  if (place.nearest >= 0) {
    const StreetSection& section = streets_.centres()[place.nearest].section;
    const double behind_kerb_m = place.outside_m - KerbAt(section, place.side);
    const bool level = place.cover == Cover::kLot;
    kerb_m = level || behind_kerb_m < 0. ? 0. : section.kerb_m;
    const double beyond_m = place.outside_m - SidewalkEnd(section, place.side);
    rough = place.cover == Cover::kByStreet ? std::clamp(beyond_m / 4., 0., 1.) : 0.;
    camber_m = -kCamber * std::min(place.across_m, section.half_width_m);
  }
  const double hump = Roughness(key_ + 7, p.x() / 12., p.y() / 12.) * 3.;
  const double tufts = Roughness(key_ + 3, p.x() / 1.1, p.y() / 1.1);
  return hills_.Height(p) + kerb_m + camber_m + road + terrain_relief_m_ * rough * (tufts + hump);
}

Ground::Heights Ground::HeightsAround(const Eigen::Vector2d& position) const {
  const Heights fine{near_.PatchAt(position.x(), position.y()), kNearNode_m};
  if (!std::isnan(fine.Between())) return fine;
  return {far_.PatchAt(position.x(), position.y()), kFarNode_m};
}

double Ground::Height(const Eigen::Vector2d& position) const {
  const double height_m = HeightsAround(position).Between();
  return std::isnan(height_m) ? Evaluate(position) : height_m;
}

Eigen::Vector3d Ground::Normal(const Eigen::Vector2d& position) const {
  const Heights heights = HeightsAround(position);
  const double u = heights.patch.u, v = heights.patch.v;
  const double to_x =
      (1. - v) * (heights.At(1) - heights.At(0)) + v * (heights.At(3) - heights.At(2));
  const double to_y =
      (1. - u) * (heights.At(2) - heights.At(0)) + u * (heights.At(3) - heights.At(1));
  if (std::isnan(to_x + to_y)) return Eigen::Vector3d::UnitZ();
  return Eigen::Vector3d(-to_x, -to_y, heights.step_m).normalized();
}

const Material& Ground::MaterialAt(const Eigen::Vector2d& position) const {
  const StreetMap::Place place = streets_.Find(position);
  if (place.cover == Cover::kLot && place.outside_m > 0.) return material::kParking;
  if (place.cover == Cover::kYard && place.outside_m > 0.) return material::kYard;
  if (place.nearest < 0) return material::kGrass;
  const CentrePoint& centre = streets_.centres()[place.nearest];
  if (place.outside_m < 0.) {
    if (centre.section.highway && place.across_m < 1.6) return material::kGrass;
    return IsMarking(centre, place.across_m, place.outside_m) ? material::kMarking
                                                              : material::kAsphalt;
  }
  if (place.outside_m < KerbAt(centre.section, place.side)) return material::kParking;
  if (place.outside_m < SidewalkEnd(centre.section, place.side)) return material::kPavement;
  return material::kGrass;
}

double Ground::Gap(const Ray& ray, double t) const {
  return ray.origin.z() + t * ray.direction.z() -
         Height(ray.origin.head<2>() + t * ray.direction.head<2>());
}

std::optional<double> Ground::Intersect(const Ray& ray, double from_m, double limit_m) const {
  const double fall = kSteepest * ray.direction.head<2>().norm() - ray.direction.z();
  if (fall <= 1e-3) return std::nullopt;  // rises faster than any slope
  double t = from_m;
  double gap_m = Gap(ray, t);
  for (; gap_m <= 0. && t > 0.; gap_m = Gap(ray, t)) t = std::max(0., t - kStepBack_m);
  if (gap_m <= 0.) return 0.;
  while (t < limit_m) {
    const double before = t, gap_before_m = gap_m;
    t = std::min(limit_m, t + std::max(gap_m / fall, kSmallestStep_m + 0.003 * t));
    gap_m = Gap(ray, t);
    if (gap_m <= 0.) return Refine(ray, before, gap_before_m, t, gap_m);
  }
  return std::nullopt;
}

double Ground::Refine(const Ray& ray, double above_t, double above_m, double below_t,
                      double below_m) const {
  // Regula falsi that halves the weight of an end that stays (the Illinois variant).
  constexpr double kExact_m = 5e-4;
  int stays = 0;
  for (int i = 0; i < 12 && below_t - above_t > kExact_m; ++i) {
    const double t = above_t + (below_t - above_t) * above_m / (above_m - below_m);
    const double gap_m = Gap(ray, t);
    if (std::abs(gap_m) < kExact_m) return t;
    if (gap_m > 0.) {
      above_t = t;
      above_m = gap_m;
      if (stays == 1) below_m *= 0.5;
      stays = 1;
    } else {
      below_t = t;
      below_m = gap_m;
      if (stays == -1) above_m *= 0.5;
      stays = -1;
    }
  }
  return 0.5 * (above_t + below_t);
}

}  // namespace semantic_kiss::simulation
