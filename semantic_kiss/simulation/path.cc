// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/path.h"

#include <algorithm>
#include <cmath>

#include "glog/logging.h"

namespace semantic_kiss::simulation {
namespace {

// Appends points along a straight or an arc, carrying the odd length left over to the next piece.
class PathSampler {
 public:
  void Straight(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const Eigen::Vector2d span = to - from;
    const double length = span.norm();
    if (length < 1e-9) return;
    yaw_ = Unwrap(std::atan2(span.y(), span.x()));
    for (; next_ < length; next_ += kPathStep_m) {
      path_.push_back({{from + next_ / length * span, yaw_}, 1e9});
    }
    next_ -= length;
  }

  // Turns by `angle` [rad, left positive] on a circle, from `from` in the present heading.
  void Arc(const Eigen::Vector2d& from, double angle, double radius_m) {
    const double sign = angle < 0. ? -1. : 1.;
    const double length = std::abs(angle) * radius_m;
    const PlanarPose start{from, yaw_};
    const Eigen::Vector2d centre = from + sign * radius_m * start.Left();
    for (; next_ < length; next_ += kPathStep_m) {
      const double yaw = yaw_ + sign * next_ / radius_m;
      const PlanarPose pose{Eigen::Vector2d::Zero(), yaw};
      path_.push_back({{centre - sign * radius_m * pose.Left(), yaw}, radius_m});
    }
    next_ -= length;
    yaw_ += angle;
  }

  std::vector<PathPoint> Take() { return std::move(path_); }

 private:
  double Unwrap(double yaw) const { return yaw_ + std::remainder(yaw - yaw_, 2. * M_PI); }

  std::vector<PathPoint> path_;
  double next_ = 0.;  // distance from the piece's start to the next point
  double yaw_ = 0.;
};

// Sideways limit first, then what can be reached and braked to.
std::vector<double> PlanSpeeds(const std::vector<PathPoint>& path, const SpeedLimits& limits) {
  std::vector<double> speeds(path.size());
  for (size_t i = 0; i < path.size(); ++i) {
    speeds[i] =
        std::min(limits.cruise_m_per_s, std::sqrt(limits.lateral_m_per_s2 * path[i].radius_m));
  }
  const double gain = 2. * limits.longitudinal_m_per_s2 * kPathStep_m;
  for (size_t i = 1; i < path.size(); ++i) {
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i - 1] * speeds[i - 1] + gain));
  }
  for (size_t i = path.size() - 1; i-- > 0;) {
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i + 1] * speeds[i + 1] + gain));
  }
  return speeds;
}

}  // namespace

std::vector<PathPoint> RoundedPath(const std::vector<Corner>& corners) {
  CHECK_GE(corners.size(), 2u);
  PathSampler sampler;
  Eigen::Vector2d from = corners.front().position;
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    const Eigen::Vector2d corner = corners[i].position;
    const Eigen::Vector2d in = corner - corners[i - 1].position;
    const Eigen::Vector2d out = corners[i + 1].position - corner;
    const double angle = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    const double room = 0.5 * std::min(in.norm(), out.norm());
    const double tangent = std::tan(0.5 * std::abs(angle));
    const double cut = std::min(corners[i].radius_m * tangent, room);
    const Eigen::Vector2d entry = corner - cut * in.normalized();
    sampler.Straight(from, entry);
    if (cut > 1e-6) sampler.Arc(entry, angle, cut / tangent);
    from = corner + cut * out.normalized();
  }
  sampler.Straight(from, corners.back().position);
  return sampler.Take();
}

std::vector<PlanarPose> DrivePath(const std::vector<PathPoint>& path, const SpeedLimits& limits,
                                  double rate_hz) {
  const std::vector<double> speeds = PlanSpeeds(path, limits);
  std::vector<PlanarPose> poses;
  double time = 0.;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const double duration = 2. * kPathStep_m / (speeds[i] + speeds[i + 1]);
    for (; poses.size() / rate_hz < time + duration;) {
      const double fraction = (poses.size() / rate_hz - time) / duration;
      const PlanarPose& a = path[i].pose;
      const PlanarPose& b = path[i + 1].pose;
      poses.push_back(
          {a.position + fraction * (b.position - a.position), a.yaw + fraction * (b.yaw - a.yaw)});
    }
    time += duration;
  }
  return poses;
}

}  // namespace semantic_kiss::simulation
