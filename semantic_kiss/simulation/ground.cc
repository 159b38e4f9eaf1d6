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

constexpr double kNode_m = 0.25;
constexpr double kDetailReach_m = 28.;  // from the carriageway's edge
// Steepest rise that the search for a ray's hit must not jump over.
constexpr double kSteepest = 0.25;
constexpr double kSmallestStep_m = 0.12;
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
      heights_(streets.bounds(), kNode_m, std::numeric_limits<float>::quiet_NaN()) {
  // Only the tiles along the streets are kept in detail.
  constexpr int kTile = SparseRaster<float>::kTile;
  const Eigen::AlignedBox2d& bounds = streets.bounds();
  std::vector<Eigen::Vector2i> tiles;
  for (int j = heights_.Node(bounds.min().y()) & ~(kTile - 1); j <= heights_.Node(bounds.max().y());
       j += kTile) {
    for (int i = heights_.Node(bounds.min().x()) & ~(kTile - 1);
         i <= heights_.Node(bounds.max().x()); i += kTile) {
      const Eigen::Vector2d centre = kNode_m * Eigen::Vector2d(i + kTile / 2, j + kTile / 2);
      if (streets.Outside(centre) < kDetailReach_m - kNode_m * kTile) tiles.emplace_back(i, j);
    }
  }
  cartographer::common::ParallelChunks(tiles.size(), 1, [&](size_t tile, size_t) {
    for (int k = 0; k < kTile * kTile; ++k) {
      const Eigen::Vector2i node = tiles[tile] + Eigen::Vector2i(k % kTile, k / kTile);
      const Eigen::Vector2d position = kNode_m * node.cast<double>();
      if (!bounds.contains(position)) continue;
      heights_.MutableAt(node.x(), node.y()) = static_cast<float>(Evaluate(position));
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

double Ground::Height(const Eigen::Vector2d& position) const {
  const auto patch = heights_.PatchAt(position.x(), position.y());
  const double height =
      Bilinear(patch, *patch.corners[0], *patch.corners[1], *patch.corners[2], *patch.corners[3]);
  return std::isnan(height) ? Evaluate(position) : height;
}

Eigen::Vector3d Ground::Normal(const Eigen::Vector2d& p) const {
  constexpr double kStep_m = 0.1;
  const Eigen::Vector2d x(kStep_m, 0.), y(0., kStep_m);
  return Eigen::Vector3d(Height(p - x) - Height(p + x), Height(p - y) - Height(p + y), 2. * kStep_m)
      .normalized();
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

std::optional<double> Ground::Intersect(const Ray& ray, double limit_m) const {
  const Eigen::Vector2d start = ray.origin.head<2>();
  const Eigen::Vector2d run = ray.direction.head<2>();
  const double fall = kSteepest * run.norm() - ray.direction.z();
  if (fall <= 1e-3) return std::nullopt;  // rises faster than any slope
  double before = 0., t = 0.;
  while (t <= limit_m) {
    const double gap = ray.origin.z() + t * ray.direction.z() - Height(start + t * run);
    if (gap <= 0.) return Refine(ray, before, t);
    before = t;
    t += std::max(gap / fall, kSmallestStep_m + 0.003 * t);
  }
  return std::nullopt;
}

double Ground::Refine(const Ray& ray, double above, double below) const {
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (above + below);
    const Eigen::Vector3d point = ray.origin + middle * ray.direction;
    (point.z() > Height(point.head<2>()) ? above : below) = middle;
  }
  return 0.5 * (above + below);
}

}  // namespace semantic_kiss::simulation
