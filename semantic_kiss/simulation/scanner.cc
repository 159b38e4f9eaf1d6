// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/scanner.h"

#include <algorithm>
#include <cmath>

#include "semantic_kiss/simulation/floor.h"
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
  Condition condition;
  std::vector<MovingThing> things;
};

// What all beams of a firing share.
struct Scanner::Column {
  int index;
  double fraction;  // of the sweep that has passed
  Eigen::Vector3d origin;
  Eigen::Matrix3d written_from_sensor;  // what deskewing does
  Eigen::Vector3d written_offset;
  std::vector<Shot> shots;                  // by beam
  std::vector<Eigen::Vector3d> directions;  // of the shots, world frame
};

Scanner::Scanner(const World& world, const Traffic& traffic, const Lidar& lidar,
                 const std::vector<Rigid3d>& world_from_lidar,
                 const proto::SimulationOptions& options)
    : world_(world),
      traffic_(traffic),
      lidar_(lidar),
      world_from_lidar_(world_from_lidar),
      options_(options),
      vertical_error_(UnitAngle::Of(options.errors().vertical_angle_deg() * M_PI / 180.)) {}

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
  state.condition = lidar_.ConditionAt(scan);
  state.things = traffic_.At(scan - 0.5, lidar_.options().max_range_m(), world_.ground());
  return state;
}

void Scanner::BeginColumn(const SweepState& sweep, int index, Column* column, RayFan* fan) const {
  column->index = index;
  column->fraction = (index + 0.5) / lidar_.columns();
  const Twist back = (column->fraction - 1.) * sweep.motion;
  const Rigid3d world_from_sensor = sweep.world_from_end * Exp(back);
  column->origin = world_from_sensor.translation();
  const Rigid3d written_from_sensor = Exp(sweep.motion_removed * back);
  column->written_from_sensor = written_from_sensor.rotation().toRotationMatrix();
  column->written_offset = written_from_sensor.translation();

  lidar_.Fire(index, sweep.condition, &column->shots);
  const Eigen::Matrix3d rotation = world_from_sensor.rotation().toRotationMatrix();
  column->directions.clear();
  for (const Shot& shot : column->shots) column->directions.push_back(rotation * shot.actual);
  fan->Open(column->origin, column->directions);
  // As seen from what moves, the sensor moves.
  const double since_middle_s = (column->fraction - 0.5) / options_.scan_rate_hz();
  for (const MovingThing& thing : sweep.things) {
    for (const Primitive& piece : thing.pieces) {
      fan->AddMoving(piece, column->origin - since_middle_s * thing.velocity);
    }
  }
}

SimulatedScan Scanner::Sweep(int scan) const {
  constexpr int kLost = -1;  // as beam
  const SweepState sweep = BeginSweep(scan);
  const uint64_t scan_key =
      HashKey({static_cast<uint64_t>(options_.seed()), static_cast<uint64_t>(Purpose::kRay),
               static_cast<uint64_t>(scan)});
  RayFan fan(world_, lidar_.options().max_range_m());
  Column column;
  SimulatedScan points(static_cast<size_t>(lidar_.beams()) * lidar_.columns());
  for (int index = 0; index < lidar_.columns(); ++index) {
    BeginColumn(sweep, index, &column, &fan);
    for (int beam = 0; beam < lidar_.beams(); ++beam) {
      const size_t place = static_cast<size_t>(beam) * lidar_.columns() + index;
      const std::optional<SimulatedPoint> point =
          Fire(column, fan, beam, HashKey({scan_key, place}));
      if (point) {
        points[place] = *point;
      } else {
        points[place].beam = kLost;
      }
    }
  }
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const SimulatedPoint& point) { return point.beam == kLost; }),
               points.end());
  return points;
}

std::optional<SimulatedPoint> Scanner::Fire(const Column& column, const RayFan& fan, int beam,
                                            uint64_t key) const {
  const Shot& shot = column.shots[beam];
  if (shot.hidden) return std::nullopt;
  Random random(key);
  const Eigen::Vector3d& direction = column.directions[beam];
  const std::optional<Hit> hit = fan.Cast(beam, random.Next());
  if (!hit || hit->range_m < lidar_.options().min_range_m()) return std::nullopt;
  if (random.Chance(hit->material.mirror)) return std::nullopt;
  // Leaves hang every way.
  const double facing = hit->texture == Texture::kCloud
                            ? random.Uniform(0.3, 1.)
                            : std::clamp(std::abs(hit->normal.dot(direction)), 0.01, 1.);
  const double remission = std::clamp(
      hit->material.remission + hit->material.remission_spread * random.QuickNormal(), 0.01, 1.);
  const Return echo{hit->range_m, remission, facing};
  if (!lidar_.Detects(echo, &random)) return std::nullopt;

  SimulatedPoint point;
  point.position = Written(column, lidar_.MeasureRange(beam, echo, &random) * shot.believed);
  point.remission = static_cast<float>(static_cast<double>(Floor(100. * remission + 0.5)) / 100.);
  point.time_s = static_cast<float>((column.fraction - 1.) / options_.scan_rate_hz());
  point.label = hit->material.label;
  point.object = hit->object;
  point.primitive = hit->primitive;
  point.moving = hit->moving;
  point.true_position = (column.origin + hit->range_m * direction).cast<float>();
  point.beam = beam;
  point.column = column.index;
  return point;
}

Eigen::Vector3f Scanner::Written(const Column& column, const Eigen::Vector3d& measured) const {
  Eigen::Vector3d point = column.written_from_sensor * measured + column.written_offset;
  // The vertical error turns the point down in the upright plane through the sensor's axis.
  const double level = point.head<2>().norm();
  if (level > 1e-9) {
    const double turned = level * vertical_error_.cosine + point.z() * vertical_error_.sine;
    point.z() = point.z() * vertical_error_.cosine - level * vertical_error_.sine;
    point.head<2>() *= turned / level;
  }
  return point.cast<float>();
}

}  // namespace semantic_kiss::simulation
