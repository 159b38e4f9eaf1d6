// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_GROUND_H_
#define SEMANTIC_KISS_SIMULATION_GROUND_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "semantic_kiss/simulation/hills.h"
#include "semantic_kiss/simulation/material.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/ray.h"
#include "semantic_kiss/simulation/sparse_raster.h"
#include "semantic_kiss/simulation/street_map.h"

namespace semantic_kiss::simulation {

// The ground: hills, kerbs, camber and unevenness, and what it is paved with.
// `streets` and `hills` must outlive it; covers must be set before it is made.
class Ground {
 public:
  Ground(const StreetMap& streets, const Hills& hills, const proto::WorldOptions& options,
         uint64_t seed);

  // The surface that rays meet [m].
  double Height(const Eigen::Vector2d& position) const;
  Eigen::Vector3d Normal(const Eigen::Vector2d& position) const;
  const Material& MaterialAt(const Eigen::Vector2d& position) const;

  // Distance along the ray to the ground, if it is met between `from_m` (where the ray should be
  // above the ground still) and `limit_m`.
  std::optional<double> Intersect(const Ray& ray, double from_m, double limit_m) const;

 private:
  // The finest heights around a point; NaN where nothing was filled in.
  struct Heights {
    SparseRaster<float>::Patch patch;
    double step_m;

    double At(int corner) const { return *patch.corners[corner]; }
    double Between() const { return Bilinear(patch, At(0), At(1), At(2), At(3)); }
  };
  Heights HeightsAround(const Eigen::Vector2d& position) const;
  double Evaluate(const Eigen::Vector2d& position) const;
  // Sets the nodes of the tiles that lie within `reach_m` of a carriageway.
  void Fill(SparseRaster<float>* raster, double reach_m) const;
  // Height of the ray over the ground.
  double Gap(const Ray& ray, double t) const;
  double Refine(const Ray& ray, double above_t, double above_m, double below_t,
                double below_m) const;

  const StreetMap& streets_;
  const Hills& hills_;
  const double road_relief_m_, terrain_relief_m_;
  const uint64_t key_;
  SparseRaster<float> near_;  // heights along the streets, NaN elsewhere
  SparseRaster<float> far_;   // coarser, all over the town
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_GROUND_H_
