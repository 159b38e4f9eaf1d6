// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_HIT_H_
#define SEMANTIC_KISS_SIMULATION_HIT_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "semantic_kiss/simulation/material.h"
#include "semantic_kiss/simulation/primitive.h"

namespace semantic_kiss::simulation {

// Object number of the ground in hits.
inline constexpr uint32_t kGroundObject = 0;

// What a ray meets.
struct Hit {
  double range_m = 0.;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // outward
  Material material;
  uint32_t object = kGroundObject;
  Texture texture = Texture::kSolid;
  // Index into World::primitives(), or of the moving pieces; -1: the ground.
  int primitive = -1;
  bool moving = false;
};

// Where a ray stops in one primitive, following its texture; nullopt if it passes. The rays of one
// key always fare alike with the same object.
std::optional<double> StopIn(const Primitive& primitive, const Stretch& stretch, uint64_t ray_key);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_HIT_H_
