// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/primitive.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace semantic_kiss::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A convex body as the part of a ray that no half-space has cut away yet.
struct Clip {
  double near = -kInfinity, far = kInfinity;
  int entry = -1;  // the half-space that cuts at `near`

  // Keeps what satisfies gap + t * approach <= 0, where gap is the origin's signed distance from
  // the plane. Returns false when nothing remains.
  bool Cut(double gap, double approach, int id) {
    if (approach == 0.) return gap <= 0.;
    const double t = -gap / approach;
    if (approach < 0.) {
      if (t > near) near = t, entry = id;
    } else {
      far = std::min(far, t);
    }
    return near <= far && far > 0.;
  }
};

// The six faces of a tapered box: axis, sign and lean of each.
struct Face {
  int axis;
  double sign;
};
constexpr Face kFaces[6] = {{0, 1.}, {0, -1.}, {1, 1.}, {1, -1.}, {2, 1.}, {2, -1.}};

double Lean(const Primitive& box, int face) { return face < 4 ? box.taper[face] : 0.; }

// Signed distance of a local point from the face's plane, times the length of its normal.
double FaceGap(const Primitive& box, int face, const Eigen::Vector3d& p) {
  const Face& f = kFaces[face];
  return f.sign * p[f.axis] - box.half[f.axis] + Lean(box, face) * (p.z() + box.half.z());
}

Eigen::Vector3d FaceNormal(const Primitive& box, int face) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  normal[kFaces[face].axis] = kFaces[face].sign;
  if (face < 4) normal.z() += Lean(box, face);
  return normal.normalized();
}

std::optional<Stretch> IntersectBox(const Primitive& box, const Eigen::Vector3d& o,
                                    const Eigen::Vector3d& d) {
  Clip clip;
  for (int face = 5; face >= 0; --face) {
    const Face& f = kFaces[face];
    const double approach = f.sign * d[f.axis] + Lean(box, face) * d.z();
    if (!clip.Cut(FaceGap(box, face, o), approach, face)) return std::nullopt;
  }
  const Eigen::Vector3d normal = clip.entry < 0 ? Eigen::Vector3d(-d) : FaceNormal(box, clip.entry);
  return Stretch{clip.near, clip.far, normal};
}

std::optional<Stretch> IntersectCylinder(const Primitive& cylinder, const Eigen::Vector3d& o,
                                         const Eigen::Vector3d& d) {
  Clip clip;
  if (!clip.Cut(o.z() - cylinder.half.z(), d.z(), 0)) return std::nullopt;
  if (!clip.Cut(-o.z() - cylinder.half.z(), -d.z(), 1)) return std::nullopt;
  const double a = d.head<2>().squaredNorm();
  const double b = o.head<2>().dot(d.head<2>());
  const double c = o.head<2>().squaredNorm() - cylinder.half.x() * cylinder.half.x();
  if (a < 1e-12) {
    if (c > 0.) return std::nullopt;
    return Stretch{clip.near, clip.far, Eigen::Vector3d(0., 0., d.z() > 0. ? -1. : 1.)};
  }
  const double discriminant = b * b - a * c;
  if (discriminant <= 0.) return std::nullopt;
  const double root = std::sqrt(discriminant);
  Eigen::Vector3d normal(0., 0., clip.entry == 0 ? 1. : -1.);
  if ((-b - root) / a > clip.near) {
    clip.near = (-b - root) / a;
    normal << (o + clip.near * d).head<2>().normalized(), 0.;
  }
  clip.far = std::min(clip.far, (-b + root) / a);
  if (clip.near > clip.far || clip.far <= 0.) return std::nullopt;
  return Stretch{clip.near, clip.far, normal};
}

std::optional<Stretch> IntersectEllipsoid(const Primitive& ellipsoid, const Eigen::Vector3d& o,
                                          const Eigen::Vector3d& d) {
  const Eigen::Vector3d scaled_o = o.cwiseQuotient(ellipsoid.half);
  const Eigen::Vector3d scaled_d = d.cwiseQuotient(ellipsoid.half);
  const double a = scaled_d.squaredNorm();
  const double b = scaled_o.dot(scaled_d);
  const double discriminant = b * b - a * (scaled_o.squaredNorm() - 1.);
  if (discriminant <= 0.) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const double near = (-b - root) / a, far = (-b + root) / a;
  if (far <= 0.) return std::nullopt;
  const Eigen::Vector3d normal = (scaled_o + near * scaled_d).cwiseQuotient(ellipsoid.half);
  return Stretch{near, far, normal.normalized()};
}

}  // namespace

void Primitive::SetYaw(double yaw) {
  cos_yaw = std::cos(yaw);
  sin_yaw = std::sin(yaw);
}

Eigen::Vector3d Primitive::ToLocal(const Eigen::Vector3d& v) const {
  return Eigen::Vector3d(cos_yaw * v.x() + sin_yaw * v.y(), cos_yaw * v.y() - sin_yaw * v.x(),
                         v.z());
}

Eigen::Vector3d Primitive::FromLocal(const Eigen::Vector3d& v) const {
  return Eigen::Vector3d(cos_yaw * v.x() - sin_yaw * v.y(), cos_yaw * v.y() + sin_yaw * v.x(),
                         v.z());
}

double Primitive::PlanarRadius() const {
  if (shape == Shape::kCylinder) return half.x();
  if (shape == Shape::kEllipsoid) return std::max(half.x(), half.y());
  return half.head<2>().norm();
}

std::optional<Stretch> Intersect(const Primitive& primitive, const Ray& ray_in_primitive) {
  const Eigen::Vector3d& o = ray_in_primitive.origin;
  const Eigen::Vector3d& d = ray_in_primitive.direction;
  switch (primitive.shape) {
    case Shape::kBox:
      return IntersectBox(primitive, o, d);
    case Shape::kCylinder:
      return IntersectCylinder(primitive, o, d);
    default:
      return IntersectEllipsoid(primitive, o, d);
  }
}

double DistanceToSurface(const Primitive& primitive, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = primitive.ToLocal(point - primitive.centre);
  double outside = -kInfinity;  // signed distance, negative within
  if (primitive.shape == Shape::kBox) {
    for (int face = 0; face < 6; ++face) {
      const double lean = Lean(primitive, face);
      outside = std::max(outside, FaceGap(primitive, face, p) / std::sqrt(1. + lean * lean));
    }
  } else if (primitive.shape == Shape::kCylinder) {
    outside =
        std::max(p.head<2>().norm() - primitive.half.x(), std::abs(p.z()) - primitive.half.z());
  } else {
    const double level = p.cwiseQuotient(primitive.half).norm();
    outside = (level - 1.) * p.norm() / std::max(level, 1e-9);
  }
  return primitive.texture == Texture::kCloud ? std::max(0., outside) : std::abs(outside);
}

}  // namespace semantic_kiss::simulation
