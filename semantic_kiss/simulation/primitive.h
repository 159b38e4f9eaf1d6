// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_PRIMITIVE_H_
#define SEMANTIC_KISS_SIMULATION_PRIMITIVE_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "semantic_kiss/simulation/material.h"
#include "semantic_kiss/simulation/ray.h"

namespace semantic_kiss::simulation {

enum class Shape : uint8_t { kBox, kCylinder, kEllipsoid };

// How rays meet a primitive.
enum class Texture : uint8_t {
  kSolid,   // at its surface
  kFacade,  // at its surface, which swells and has windows set back into it
  kPorous,  // at its surface or not at all: wire and pickets
  kCloud,   // inside, at a random depth: leaves
};

// One convex piece of the world, upright (turned about the vertical only).
//   kBox        half extents along its own x, y and z; each of the sides may lean in by `taper`
//               (metres of narrowing a metre of height, order +x, -x, +y, -y), so that a box can be
//               a gable, a windscreen or a wedge
//   kCylinder   half.x() is the radius, half.z() half of the height
//   kEllipsoid  semi-axes
struct Primitive {
  Shape shape = Shape::kBox;
  Texture texture = Texture::kSolid;
  Material material;
  // The thing that this is a piece of: stable from epoch to epoch for what is not movable.
  uint32_t object = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double cos_yaw = 1., sin_yaw = 0.;
  Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5);
  float taper[4] = {0.f, 0.f, 0.f, 0.f};
  // kCloud: returns a metre of way through it; kPorous: share of rays that it stops.
  float density = 1.f;

  void SetYaw(double yaw);
  Eigen::Vector3d ToLocal(const Eigen::Vector3d& direction) const;  // rotates only
  Eigen::Vector3d FromLocal(const Eigen::Vector3d& direction) const;
  double Top() const { return centre.z() + half.z(); }
  double Bottom() const { return centre.z() - half.z(); }
  // Radius around the centre, seen from above.
  double PlanarRadius() const;
};

// The stretch of a ray inside of a primitive, near <= far, far > 0; near < 0: the ray starts
// inside. Ray and normal in the primitive's own frame: from its centre, along its axes.
struct Stretch {
  double near, far;
  Eigen::Vector3d normal;  // of the surface at `near`, outward
};
std::optional<Stretch> Intersect(const Primitive& primitive, const Ray& ray_in_primitive);

// Distance of a point from the surface of the primitive (of a cloud: from its inside, 0 within):
// exact for points in front of a face, a lower bound beyond edges.
double DistanceToSurface(const Primitive& primitive, const Eigen::Vector3d& point);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_PRIMITIVE_H_
