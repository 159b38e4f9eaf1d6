// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/scanner.h"

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {

using cartographer::transform::Exp;
using cartographer::transform::Log;
using cartographer::transform::Rigid3d;
using cartographer::transform::Twist;

// What all columns of a sweep share.
struct Scanner::SweepState {
  int scan;
  Rigid3d world_from_end;
  Twist motion;           // during the sweep: end = start * Exp(motion)
  double motion_removed;  // share of it that deskewing takes out
  std::vector<MovingThing> things;
};

// What all beams of a firing share.
struct Scanner::Column {
  double fraction;        // of the sweep that has passed
  double since_middle_s;  // of the sweep
  int index;
  Eigen::Vector3d origin;
  Eigen::Matrix3d world_from_sensor;
  Eigen::Matrix3d written_from_sensor;  // what deskewing does
  Eigen::Vector3d written_offset;
  std::vector<const MovingThing*> things;  // that a beam may meet
};

Scanner::Scanner(const World& world, const Traffic& traffic, const Lidar& lidar,
                 const std::vector<Rigid3d>& world_from_lidar,
                 const proto::SimulationOptions& options)
    : world_(world),
      traffic_(traffic),
      lidar_(lidar),
      world_from_lidar_(world_from_lidar),
      options_(options) {}

Scanner::SweepState Scanner::BeginSweep(int scan) const {
  SweepState state;
  state.scan = scan;
  state.world_from_end = world_from_lidar_[scan];
  // Before the first pose the car moves as it does after it.
  const int next = std::max(1, scan);
  state.motion = Log(world_from_lidar_[next - 1].inverse() * world_from_lidar_[next]);
  Random random(options_.seed(), Purpose::kMotion, static_cast<uint64_t>(scan));
  const proto::ErrorOptions& errors = options_.errors();
  const double residual =
      errors.deskew_residual() + errors.deskew_residual_noise() * random.Normal();
  state.motion_removed = options_.raw() ? 0. : 1. - residual;
  state.things = traffic_.At(scan - 0.5, lidar_.options().max_range_m(), world_.ground());
  return state;
}

Scanner::Column Scanner::BeginColumn(const SweepState& sweep, int index) const {
  Column column;
  column.index = index;
  column.fraction = (index + 0.5) / lidar_.columns();
  column.since_middle_s = (column.fraction - 0.5) / options_.scan_rate_hz();
  const Twist back = (column.fraction - 1.) * sweep.motion;
  const Rigid3d world_from_sensor = sweep.world_from_end * Exp(back);
  column.origin = world_from_sensor.translation();
  column.world_from_sensor = world_from_sensor.rotation().toRotationMatrix();
  const Rigid3d written_from_sensor = Exp(sweep.motion_removed * back);
  column.written_from_sensor = written_from_sensor.rotation().toRotationMatrix();
  column.written_offset = written_from_sensor.translation();

  const double azimuth = lidar_.NominalAzimuth(index);
  const Eigen::Vector2d ahead =
      (column.world_from_sensor * Bearing{0., azimuth}.Direction()).head<2>();
  for (const MovingThing& thing : sweep.things) {
    // Generous: beams differ a little in azimuth, and the thing moves during the sweep.
    const Eigen::Vector2d offset = thing.centre - column.origin.head<2>();
    const double reach = thing.radius_m + 0.06 * offset.norm() + 3.;
    const double across = offset.x() * ahead.y() - offset.y() * ahead.x();
    if (std::abs(across) < reach && offset.dot(ahead) > -reach) column.things.push_back(&thing);
  }
  return column;
}

SimulatedScan Scanner::Sweep(int scan) const {
  const SweepState sweep = BeginSweep(scan);
  std::vector<SimulatedScan> by_beam(lidar_.beams());
  for (SimulatedScan& points : by_beam) points.reserve(lidar_.columns());
  for (int index = 0; index < lidar_.columns(); ++index) {
    const Column column = BeginColumn(sweep, index);
    for (int beam = 0; beam < lidar_.beams(); ++beam) {
      const uint64_t key =
          HashKey({static_cast<uint64_t>(options_.seed()), static_cast<uint64_t>(Purpose::kRay),
                   static_cast<uint64_t>(scan),
                   static_cast<uint64_t>(beam) << 32 | static_cast<uint64_t>(index)});
      const std::optional<SimulatedPoint> point = Fire(column, beam, key);
      if (point) by_beam[beam].push_back(*point);
    }
  }
  SimulatedScan scan_points;
  scan_points.reserve(static_cast<size_t>(lidar_.columns()) * lidar_.beams());
  for (const SimulatedScan& points : by_beam) {
    scan_points.insert(scan_points.end(), points.begin(), points.end());
  }
  return scan_points;
}

std::optional<SimulatedPoint> Scanner::Fire(const Column& column, int beam, uint64_t key) const {
  const Bearing nominal = lidar_.Nominal(beam, column.index);
  if (lidar_.Hidden(nominal)) return std::nullopt;
  Random random(key);
  const Ray ray{column.origin, column.world_from_sensor * lidar_.True(beam, nominal).Direction()};
  const std::optional<Hit> hit = Cast(column, ray, random.Next());
  if (!hit || hit->range_m < lidar_.options().min_range_m()) return std::nullopt;
  if (random.Chance(hit->material.mirror)) return std::nullopt;
  // Leaves hang every way.
  const double facing = hit->texture == Texture::kCloud
                            ? random.Uniform(0.3, 1.)
                            : std::clamp(std::abs(hit->normal.dot(ray.direction)), 0.01, 1.);
  const double remission = std::clamp(
      hit->material.remission + hit->material.remission_spread * random.Normal(), 0.01, 1.);
  const Return echo{hit->range_m, remission, facing};
  if (!lidar_.Detects(echo, &random)) return std::nullopt;

  SimulatedPoint point;
  point.position = Written(column, lidar_.MeasureRange(beam, echo, &random) * nominal.Direction());
  point.remission = static_cast<float>(std::round(100. * remission) / 100.);
  point.time_s = static_cast<float>((column.fraction - 1.) / options_.scan_rate_hz());
  point.label = hit->material.label;
  point.object = hit->object;
  point.primitive = hit->primitive;
  point.moving = hit->moving;
  point.true_position = (ray.origin + hit->range_m * ray.direction).cast<float>();
  point.beam = beam;
  point.column = column.index;
  return point;
}

std::optional<Hit> Scanner::Cast(const Column& column, const Ray& ray, uint64_t key) const {
  std::optional<Hit> best = world_.Cast(ray, lidar_.options().max_range_m(), key);
  double limit_m = best ? best->range_m : lidar_.options().max_range_m();
  for (const MovingThing* thing : column.things) {
    // As seen from the thing, the sensor moves.
    const Ray seen{ray.origin - column.since_middle_s * thing->velocity, ray.direction};
    for (const Primitive& piece : thing->pieces) {
      const std::optional<Stretch> stretch = Intersect(piece, seen);
      if (!stretch || stretch->near > limit_m) continue;
      const std::optional<double> t = StopIn(piece, *stretch, key);
      if (!t || *t >= limit_m) continue;
      limit_m = *t;
      best = Hit{*t, stretch->normal, piece.material, piece.object, piece.texture, -1, true};
    }
  }
  return best;
}

Eigen::Vector3f Scanner::Written(const Column& column, const Eigen::Vector3d& measured) const {
  Eigen::Vector3d point = column.written_from_sensor * measured + column.written_offset;
  // The vertical error turns the point down in the upright plane through the sensor's axis.
  const double angle_rad = options_.errors().vertical_angle_deg() * M_PI / 180.;
  const double level = point.head<2>().norm();
  if (level > 1e-9) {
    const double turned = level * std::cos(angle_rad) + point.z() * std::sin(angle_rad);
    point.z() = point.z() * std::cos(angle_rad) - level * std::sin(angle_rad);
    point.head<2>() *= turned / level;
  }
  return point.cast<float>();
}

}  // namespace semantic_kiss::simulation
