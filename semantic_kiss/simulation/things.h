// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_THINGS_H_
#define SEMANTIC_KISS_SIMULATION_THINGS_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/random.h"

// The things that towns are made of, each assembled from a few primitives. All take the place where
// the thing stands on the ground (world frame) and draw their proportions from `random`.
namespace semantic_kiss::simulation {

struct Stand {
  Eigen::Vector3d foot;  // on the ground [m]
  double yaw = 0.;       // [rad], the thing's x axis
  uint32_t object = 0;   // number of the thing
};

// Footprints of vehicles, for whoever leaves room for them [m].
inline constexpr double kCarLength_m = 4.4, kCarWidth_m = 1.8;
inline constexpr double kTruckLength_m = 7.5, kTruckWidth_m = 2.3;

std::vector<Primitive> MakeCar(const Stand& stand, bool moving, Random random);
std::vector<Primitive> MakeTruck(const Stand& stand, bool moving, Random random);
std::vector<Primitive> MakeCyclist(const Stand& stand, bool moving, Random random);
std::vector<Primitive> MakePerson(const Stand& stand, bool moving, Random random);

// `crown_bottom_m`: least height of the leaves over the ground.
std::vector<Primitive> MakeTree(const Stand& stand, double crown_bottom_m, Random random);
std::vector<Primitive> MakeBush(const Stand& stand, Random random);

// A lamp whose arm reaches along +x.
std::vector<Primitive> MakeLamp(const Stand& stand, Random random);
// A sign that faces -x: what traffic heading along +x sees.
std::vector<Primitive> MakeTrafficSign(const Stand& stand, Random random);
std::vector<Primitive> MakeTrafficLight(const Stand& stand, Random random);
std::vector<Primitive> MakeBin(const Stand& stand, Random random);

// A wall, hedge or fence between two points on the ground.
enum class BarrierKind { kHedge, kFence, kWall, kGuardRail };
std::vector<Primitive> MakeBarrier(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   BarrierKind kind, double height_m, uint32_t object);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_THINGS_H_
