// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/hit.h"

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {

std::optional<double> StopIn(const Primitive& primitive, const Stretch& stretch, uint64_t ray_key) {
  switch (primitive.texture) {
    case Texture::kCloud: {
      const double chance = ToUniform(HashKey({ray_key, primitive.object}));
      const double depth_m = -std::log(1. - chance) / primitive.density;
      const double t = std::max(stretch.near, 0.) + depth_m;
      if (t > stretch.far) return std::nullopt;
      return t;
    }
    case Texture::kPorous:
      if (ToUniform(HashKey({ray_key, primitive.object})) > primitive.density) return std::nullopt;
      break;
    default:
      break;
  }
  if (stretch.near < 0.) return std::nullopt;
  return stretch.near;
}

}  // namespace semantic_kiss::simulation
