// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/things.h"

#include <algorithm>
#include <cmath>

namespace semantic_kiss::simulation {
namespace {

// A piece of a thing: `offset` is from the thing's foot, along its own axes.
Primitive Piece(const Stand& stand, Shape shape, const Material& material,
                const Eigen::Vector3d& offset, const Eigen::Vector3d& half) {
  Primitive piece;
  piece.shape = shape;
  piece.material = material;
  piece.object = stand.object;
  piece.SetYaw(stand.yaw);
  piece.centre = stand.foot + piece.FromLocal(offset);
  piece.half = half;
  return piece;
}

// No two things of a kind reflect alike.
Material Tint(Material material, Random* random) {
  material.remission = static_cast<float>(
      std::clamp(material.remission + material.remission_spread * random->Normal(), 0.02, 1.));
  return material;
}

Primitive Pole(const Stand& stand, double radius_m, double height_m, const Material& material) {
  return Piece(stand, Shape::kCylinder, material, {0., 0., 0.5 * height_m - 0.1},
               {radius_m, radius_m, 0.5 * height_m + 0.1});
}

Primitive Leaves(const Stand& stand, const Eigen::Vector3d& offset, const Eigen::Vector3d& half,
                 double density, Random* random) {
  Primitive leaves = Piece(stand, Shape::kEllipsoid, Tint(material::kLeaves, random), offset, half);
  leaves.texture = Texture::kCloud;
  leaves.density = static_cast<float>(density);
  return leaves;
}

}  // namespace

std::vector<Primitive> MakeCar(const Stand& stand, bool moving, Random random) {
  const double length_m = kCarLength_m * random.Uniform(0.85, 1.1);
  const double width_m = kCarWidth_m * random.Uniform(0.95, 1.03);
  const double roof_m = random.Uniform(1.4, 1.75);
  const double bonnet_m = random.Uniform(0.85, 1.0);
  const bool van = random.Chance(0.2);
  const Material paint = Tint(moving ? material::kMovingCarPaint : material::kCarPaint, &random);
  const Material glass = moving ? material::kMovingCarGlass : material::kCarGlass;
  constexpr double kBelly_m = 0.22;

  Primitive body = Piece(stand, Shape::kBox, paint, {0., 0., 0.5 * (kBelly_m + bonnet_m)},
                         {0.5 * length_m, 0.5 * width_m, 0.5 * (bonnet_m - kBelly_m)});
  std::fill(body.taper, body.taper + 4, 0.1f);
  const double cabin_m = van ? 0.8 * length_m : 0.62 * length_m;
  Primitive cabin =
      Piece(stand, Shape::kBox, glass,
            {van ? -0.05 * length_m : -0.08 * length_m, 0., 0.5 * (bonnet_m + roof_m)},
            {0.5 * cabin_m, 0.47 * width_m, 0.5 * (roof_m - bonnet_m)});
  cabin.taper[0] = van ? 0.6f : 1.1f;
  cabin.taper[1] = van ? 0.15f : 0.7f;
  cabin.taper[2] = cabin.taper[3] = 0.3f;
  const double roof_half_m =
      0.5 * cabin_m - 0.5 * (cabin.taper[0] + cabin.taper[1]) * (roof_m - bonnet_m);
  const double roof_shift_m = 0.5 * (cabin.taper[1] - cabin.taper[0]) * (roof_m - bonnet_m);
  Primitive roof = Piece(stand, Shape::kBox, paint,
                         {(van ? -0.05 : -0.08) * length_m + roof_shift_m, 0., roof_m},
                         {std::max(0.3, roof_half_m), 0.4 * width_m, 0.03});
  std::vector<Primitive> pieces = {body, cabin, roof};
  for (const double x : {0.31, -0.31}) {
    // Both wheels of an axle as one block: nothing is seen between them.
    pieces.push_back(
        Piece(stand, Shape::kBox, paint, {x * length_m, 0., 0.3}, {0.3, 0.48 * width_m, 0.3}));
  }
  return pieces;
}

std::vector<Primitive> MakeTruck(const Stand& stand, bool moving, Random random) {
  const double length_m = kTruckLength_m * random.Uniform(0.8, 1.05);
  const double height_m = random.Uniform(2.6, 3.4);
  const Material body = Tint(moving ? material::kMovingTruck : material::kTruckBody, &random);
  const double half_width_m = 0.5 * kTruckWidth_m;
  Primitive cab = Piece(stand, Shape::kBox, body, {0.5 * length_m - 0.9, 0., 1.4},
                        {0.9, 0.95 * half_width_m, 1.0});
  cab.taper[0] = 0.15f;
  return {cab,
          Piece(stand, Shape::kBox, body, {-1.0, 0., 0.5 * (height_m + 0.9)},
                {0.5 * length_m - 1.0, half_width_m, 0.5 * (height_m - 0.9)}),
          Piece(stand, Shape::kBox, body, {-0.5, 0., 0.55},
                {0.4 * length_m, 0.8 * half_width_m, 0.35})};
}

std::vector<Primitive> MakeCyclist(const Stand& stand, bool moving, Random random) {
  const Material material = Tint(moving ? material::kMovingBicyclist : material::kBicycle, &random);
  Primitive frame = Piece(stand, Shape::kBox, material, {0., 0., 0.5}, {0.85, 0.06, 0.45});
  frame.texture = Texture::kPorous;
  frame.density = 0.5f;
  std::vector<Primitive> pieces = {frame};
  if (moving) {
    pieces.push_back(Piece(stand, Shape::kEllipsoid, material, {-0.1, 0., 1.2}, {0.3, 0.25, 0.5}));
    pieces.push_back(Piece(stand, Shape::kEllipsoid, material, {0., 0., 1.75}, {0.14, 0.12, 0.16}));
  }
  return pieces;
}

std::vector<Primitive> MakePerson(const Stand& stand, bool moving, Random random) {
  const Material material = Tint(moving ? material::kMovingPerson : material::kPerson, &random);
  const double size = random.Uniform(0.85, 1.1);
  return {Piece(stand, Shape::kEllipsoid, material, {0., 0., 1.1 * size},
                {0.17 * size, 0.26 * size, 0.45 * size}),
          Piece(stand, Shape::kCylinder, material, {0., 0., 0.4 * size},
                {0.14 * size, 0.14 * size, 0.42 * size}),
          Piece(stand, Shape::kEllipsoid, material, {0., 0., 1.63 * size},
                {0.1 * size, 0.1 * size, 0.13 * size})};
}

std::vector<Primitive> MakeTree(const Stand& stand, double crown_bottom_m, Random random) {
  const double bottom_m = std::max(crown_bottom_m, random.Uniform(1.8, 3.));
  const double radius_m = random.Uniform(1.4, 3.2);
  const double half_height_m = radius_m * random.Uniform(0.8, 1.5);
  std::vector<Primitive> pieces = {
      Pole(stand, random.Uniform(0.08, 0.2), bottom_m + half_height_m, material::kBark)};
  const int lobes = 2 + random.Index(3);
  for (int i = 0; i < lobes; ++i) {
    const double angle = random.Uniform(0., 2. * M_PI);
    const double away_m = random.Uniform(0., 0.4) * radius_m;
    const double share = random.Uniform(0.65, 1.);
    const double rise_m = random.Uniform(0.8, 1.5) * half_height_m;
    pieces.push_back(Leaves(
        stand, {away_m * std::cos(angle), away_m * std::sin(angle), bottom_m + rise_m},
        {share * radius_m * 0.75, share * radius_m * 0.75, std::min(share * half_height_m, rise_m)},
        random.Uniform(0.5, 2.2), &random));
  }
  return pieces;
}

std::vector<Primitive> MakeBush(const Stand& stand, Random random) {
  const double radius_m = random.Uniform(0.5, 1.7);
  const double height_m = radius_m * random.Uniform(0.7, 1.2);
  return {Leaves(stand, {0., 0., 0.6 * height_m},
                 {radius_m, radius_m * random.Uniform(0.7, 1.3), height_m}, random.Uniform(2., 6.),
                 &random)};
}

std::vector<Primitive> MakeLamp(const Stand& stand, Random random) {
  const double height_m = random.Uniform(5., 8.);
  const double arm_m = random.Uniform(0.8, 1.8);
  return {Pole(stand, random.Uniform(0.06, 0.1), height_m, Tint(material::kPole, &random)),
          Piece(stand, Shape::kBox, material::kPole, {0.5 * arm_m, 0., height_m},
                {0.5 * arm_m, 0.05, 0.05}),
          Piece(stand, Shape::kBox, material::kPole, {arm_m, 0., height_m}, {0.3, 0.12, 0.08})};
}

std::vector<Primitive> MakeTrafficSign(const Stand& stand, Random random) {
  const double height_m = random.Uniform(2.2, 2.9);
  const double half_m = random.Uniform(0.25, 0.42);
  return {Pole(stand, 0.04, height_m, material::kPole),
          Piece(stand, Shape::kBox, Tint(material::kSign, &random), {-0.06, 0., height_m},
                {0.015, half_m, half_m})};
}

std::vector<Primitive> MakeTrafficLight(const Stand& stand, Random random) {
  const double height_m = random.Uniform(2.6, 3.2);
  return {
      Pole(stand, 0.07, height_m, Tint(material::kPole, &random)),
      Piece(stand, Shape::kBox, material::kPole, {-0.15, 0., height_m - 0.4}, {0.12, 0.16, 0.45})};
}

std::vector<Primitive> MakeBin(const Stand& stand, Random random) {
  const double half_m = random.Uniform(0.25, 0.45);
  const double height_m = random.Uniform(0.8, 1.3);
  return {Piece(stand, Shape::kBox, Tint(material::kBin, &random), {0., 0., 0.5 * height_m},
                {half_m, half_m * random.Uniform(0.8, 1.6), 0.5 * height_m})};
}

std::vector<Primitive> MakeBarrier(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   BarrierKind kind, double height_m, uint32_t object) {
  const Eigen::Vector3d span = to - from;
  const Stand stand{0.5 * (from + to), std::atan2(span.y(), span.x()), object};
  const double half_length_m = 0.5 * span.head<2>().norm();
  const auto upright = [&](const Material& material, double half_thickness_m, double bottom_m) {
    return Piece(stand, Shape::kBox, material, {0., 0., 0.5 * (height_m + bottom_m)},
                 {half_length_m, half_thickness_m, 0.5 * (height_m - bottom_m)});
  };
  Primitive barrier;
  switch (kind) {
    case BarrierKind::kHedge:
      barrier = upright(material::kLeaves, 0.4, -0.3);
      barrier.texture = Texture::kCloud;
      barrier.density = 6.f;
      break;
    case BarrierKind::kFence:
      barrier = upright(material::kFence, 0.03, -0.2);
      barrier.texture = Texture::kPorous;
      barrier.density = 0.45f;
      break;
    case BarrierKind::kWall:
      barrier = upright(material::kGardenWall, 0.14, -0.5);
      break;
    case BarrierKind::kGuardRail:
      barrier = upright(material::kGuardRail, 0.06, height_m - 0.32);
      break;
  }
  return {barrier};
}

}  // namespace semantic_kiss::simulation
