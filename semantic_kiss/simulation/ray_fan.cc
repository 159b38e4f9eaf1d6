// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/ray_fan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "semantic_kiss/simulation/facade.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A fan whose rays drift apart by more than this a metre is not narrow.
constexpr double kWidestDrift = 0.4;
// Keeps rounding from losing what a ray only just meets.
constexpr double kSlack = 1e-6;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Half of the primitive's width across a planar unit vector, along `axis`.
double HalfExtent(const Primitive& primitive, const Eigen::Vector2d& axis) {
  if (primitive.shape == Shape::kCylinder) return primitive.half.x();
  const double x = primitive.cos_yaw * axis.x() + primitive.sin_yaw * axis.y();
  const double y = primitive.cos_yaw * axis.y() - primitive.sin_yaw * axis.x();
  if (primitive.shape == Shape::kBox) {
    return std::abs(x) * primitive.half.x() + std::abs(y) * primitive.half.y();
  }
  const double u = x * primitive.half.x(), v = y * primitive.half.y();
  return std::sqrt(u * u + v * v);
}

// The slope towards something `rise` above the origin, least or steepest over distances from near
// to far.
double LowestSlope(double rise, double near, double far) {
  if (rise > 0.) return rise / far;
  return near > 0. ? rise / near : -kInfinity;
}
double HighestSlope(double rise, double near, double far) {
  if (rise < 0.) return rise / far;
  return near > 0. ? rise / near : kInfinity;
}

}  // namespace

RayFan::RayFan(const World& world, double reach_m)
    : world_(world),
      reach_m_(reach_m),
      profile_(world.ground(), reach_m),
      seen_in_fan_(world.primitives().size(), 0) {}

void RayFan::Open(const Eigen::Vector3d& origin, const std::vector<Eigen::Vector3d>& directions) {
  origin_ = origin;
  directions_ = directions;
  FindWedge();
  if (narrow_) profile_.Take(origin_, wedge_.heading);
  FindCandidates();
}

void RayFan::FindWedge() {
  slants_.clear();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& direction : directions_) {
    const double run = std::max(1e-9, direction.head<2>().norm());
    slants_.push_back({run, direction.z() / run});
    sum += direction.head<2>() / run;
  }
  wedge_.tip = origin_.head<2>();
  wedge_.reach_m = reach_m_;
  wedge_.heading = sum.normalized();
  wedge_.left = -kInfinity;
  wedge_.right = kInfinity;
  narrow_ = true;
  for (const Eigen::Vector3d& direction : directions_) {
    const double ahead = wedge_.heading.dot(direction.head<2>());
    const double aside = Cross(wedge_.heading, direction.head<2>());
    // Written so that it fails for upright rays, too.
    narrow_ = narrow_ && std::abs(aside) < kWidestDrift * ahead;
    wedge_.left = std::max(wedge_.left, aside / ahead + kSlack);
    wedge_.right = std::min(wedge_.right, aside / ahead - kSlack);
  }
}

void RayFan::FindCandidates() {
  candidates_.clear();
  ++fan_;
  const auto visit = [&](uint32_t index) {
    if (seen_in_fan_[index] == fan_) return;
    seen_in_fan_[index] = fan_;
    Consider(world_.primitives()[index], static_cast<int>(index), origin_);
  };
  if (narrow_) {
    world_.grid().ForEachIn(wedge_, visit);
  } else {
    world_.grid().ForEachAround(wedge_.tip, reach_m_, visit);
  }
  // By index among equals, so that what is met does not depend on what else is there.
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.near_m, a.index) < std::tie(b.near_m, b.index);
  });
}

void RayFan::Consider(const Primitive& primitive, int index, const Eigen::Vector3d& origin) {
  const Eigen::Vector2d offset = primitive.centre.head<2>() - origin.head<2>();
  double near = 0., far = reach_m_;
  if (narrow_) {
    const Eigen::Vector2d left = wedge_.LeftEdge().normalized();
    const Eigen::Vector2d right = wedge_.RightEdge().normalized();
    if (Cross(left, offset) > HalfExtent(primitive, {-left.y(), left.x()})) return;
    if (-Cross(right, offset) > HalfExtent(primitive, {-right.y(), right.x()})) return;
    const double ahead = wedge_.heading.dot(offset);
    const double extent = HalfExtent(primitive, wedge_.heading) + kSlack;
    if (ahead + extent < 0. || ahead - extent > reach_m_) return;
    near = std::max(0., ahead - extent);
    // Rays that drift aside go a longer way for a metre ahead.
    const double drift = std::max(std::abs(wedge_.left), std::abs(wedge_.right));
    far = (ahead + extent) * std::sqrt(1. + drift * drift);
  } else {
    const double distance = offset.norm(), radius = primitive.PlanarRadius() + kSlack;
    if (distance - radius > reach_m_) return;
    near = std::max(0., distance - radius);
    far = distance + radius;
  }
  Candidate candidate;
  candidate.primitive = &primitive;
  candidate.index = index;
  candidate.origin = primitive.ToLocal(origin - primitive.centre);
  candidate.near_m = near;
  candidate.lowest_slope = LowestSlope(primitive.Bottom() - kSlack - origin.z(), near, far);
  candidate.highest_slope = HighestSlope(primitive.Top() + kSlack - origin.z(), near, far);
  candidates_.push_back(candidate);
}

void RayFan::AddMoving(const Primitive& piece, const Eigen::Vector3d& origin) {
  const size_t before = candidates_.size();
  Consider(piece, -1, origin);
  if (candidates_.size() == before) return;
  const auto place =
      std::upper_bound(candidates_.begin(), candidates_.end() - 1, candidates_.back(),
                       [](const Candidate& a, const Candidate& b) { return a.near_m < b.near_m; });
  std::rotate(place, candidates_.end() - 1, candidates_.end());
}

std::optional<double> RayFan::MeetGround(size_t index) const {
  const Slant& slant = slants_[index];
  const double clear_m = narrow_ ? profile_.ClearUntil(slant.slope) : 0.;
  if (clear_m > reach_m_) return std::nullopt;
  return world_.ground().Intersect({origin_, directions_[index]}, clear_m / slant.run, reach_m_);
}

std::optional<Hit> RayFan::Cast(size_t index, uint64_t ray_key) const {
  const Eigen::Vector3d& direction = directions_[index];
  const Slant& slant = slants_[index];
  const std::optional<double> ground = MeetGround(index);
  double best = ground.value_or(reach_m_);
  double best_run_m = best * slant.run;
  const Candidate* nearest = nullptr;
  Stretch nearest_stretch;
  for (const Candidate& candidate : candidates_) {
    if (candidate.near_m > best_run_m) break;
    if (slant.slope < candidate.lowest_slope || slant.slope > candidate.highest_slope) continue;
    const Primitive& primitive = *candidate.primitive;
    const std::optional<Stretch> stretch =
        Intersect(primitive, {candidate.origin, primitive.ToLocal(direction)});
    if (!stretch || stretch->near >= best) continue;
    const std::optional<double> t = StopIn(primitive, *stretch, ray_key);
    if (!t || *t >= best) continue;
    best = *t;
    best_run_m = best * slant.run;
    nearest = &candidate;
    nearest_stretch = *stretch;
  }
  const Ray ray{origin_, direction};
  if (nearest != nullptr) return HitOf(*nearest, ray, nearest_stretch, best);
  if (!ground) return std::nullopt;
  const Eigen::Vector2d point = (origin_ + *ground * direction).head<2>();
  return Hit{*ground, world_.ground().Normal(point), world_.ground().MaterialAt(point)};
}

Hit RayFan::HitOf(const Candidate& candidate, const Ray& ray, const Stretch& stretch,
                  double t) const {
  const Primitive& primitive = *candidate.primitive;
  Hit hit{t,
          primitive.FromLocal(stretch.normal),
          primitive.material,
          primitive.object,
          primitive.texture,
          candidate.index,
          candidate.index < 0};
  if (primitive.texture == Texture::kFacade) {
    ShapeFacade(primitive, ray, world_.wall_relief_m(), world_.seed(), &hit);
  }
  return hit;
}

}  // namespace semantic_kiss::simulation
