// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_RAY_FAN_H_
#define SEMANTIC_KISS_SIMULATION_RAY_FAN_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "semantic_kiss/simulation/ground_profile.h"
#include "semantic_kiss/simulation/hit.h"
#include "semantic_kiss/simulation/primitive.h"
#include "semantic_kiss/simulation/primitive_grid.h"
#include "semantic_kiss/simulation/ray.h"
#include "semantic_kiss/simulation/world.h"

namespace semantic_kiss::simulation {

// Casts rays that leave one point and, seen from above, lie close together, as the beams of one
// firing do: what they may meet is looked up once for all of them. Rays that don't lie close are
// cast as correctly, but slowly.
//
// Keeps room for its work from fan to fan, so use one a thread.
class RayFan {
 public:
  // `world` must outlive the fan.
  RayFan(const World& world, double reach_m);

  // Begins a fan of rays from `origin` along `directions` (unit, world frame; at least one).
  void Open(const Eigen::Vector3d& origin, const std::vector<Eigen::Vector3d>& directions);

  // Adds something that is not part of the world to what the rays of this fan may meet. It sees
  // them leave `origin`: if it moves, not where the world does.
  void AddMoving(const Primitive& piece, const Eigen::Vector3d& origin);

  // The first thing within reach that stops the ray along directions[index], if any. `ray_key`
  // decides chances: how deep leaves are entered, whether a fence or a pane lets the ray pass.
  std::optional<Hit> Cast(size_t index, uint64_t ray_key) const;

 private:
  struct Candidate {
    const Primitive* primitive;
    int index;               // in the world, -1 if moving
    Eigen::Vector3d origin;  // of the rays, in the primitive's frame
    // Rays can meet it only beyond this distance in the plane, and if they rise by that much a
    // metre.
    double near_m, lowest_slope, highest_slope;
  };
  struct Slant {
    double run;    // way in the plane a metre of ray
    double slope;  // rise a metre of that
  };

  void FindWedge();
  void Consider(const Primitive& primitive, int index, const Eigen::Vector3d& origin);
  void FindCandidates();
  std::optional<double> MeetGround(size_t index) const;
  Hit HitOf(const Candidate& candidate, const Ray& ray, const Stretch& stretch, double t) const;

  const World& world_;
  const double reach_m_;
  GroundProfile profile_;
  Eigen::Vector3d origin_;
  std::vector<Eigen::Vector3d> directions_;
  std::vector<Slant> slants_;
  bool narrow_ = true;  // whether wedge_ and profile_ hold
  Wedge wedge_;
  std::vector<Candidate> candidates_;  // nearest first
  std::vector<uint32_t> seen_in_fan_;  // by primitive
  uint32_t fan_ = 0;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_RAY_FAN_H_
