// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_SCAN_MATCHING_ROOM_SCENE_H_
#define TEST_CARTOGRAPHER_SCAN_MATCHING_ROOM_SCENE_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/submap/probability_grid.h"

namespace cartographer::scan_matching {

using PlanarPoints = std::vector<Eigen::Vector2d>;

// Walls of a room of 20 m by 12 m with a niche, every 7 cm, about the origin. They run through the
// middle of cells, so that cutting the plane into cells moves nothing.
inline PlanarPoints RoomWalls() {
  const PlanarPoints corners = {{-9.95, -5.95}, {9.95, -5.95}, {9.95, 5.95}, {4.05, 5.95},
                                {4.05, 4.05},   {1.05, 4.05},  {1.05, 5.95}, {-9.95, 5.95}};
  PlanarPoints walls;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % corners.size()] - corners[i];
    for (double along = 0.; along < side.norm(); along += 0.07) {
      walls.push_back(corners[i] + along * side.normalized());
    }
  }
  return walls;
}

// Two walls along x without an end in sight.
inline PlanarPoints CorridorWalls() {
  PlanarPoints walls;
  for (double x = -10.; x < 10.; x += 0.07) {
    walls.emplace_back(x, 1.95);
    walls.emplace_back(x, -1.95);
  }
  return walls;
}

// The points in the frame of a scan taken from a pose.
inline PlanarPoints SeenFrom(const PlanarPose& grid_from_scan, const PlanarPoints& points) {
  const Eigen::Rotation2Dd scan_from_grid(-grid_from_scan.yaw_rad);
  PlanarPoints seen;
  for (const Eigen::Vector2d& point : points) {
    seen.emplace_back(scan_from_grid * (point - grid_from_scan.translation));
  }
  return seen;
}

// A grid of 10 cm that has seen the points from the origin a few times.
inline submap::ProbabilityGrid GridOf(const PlanarPoints& points) {
  submap::proto::ProbabilityGridOptions options;
  options.set_resolution_m(0.1);
  options.set_hit_probability(0.6);
  options.set_miss_probability(0.45);
  options.set_cast_rays(true);
  submap::ProbabilityGrid grid(options);
  for (int i = 0; i < 4; ++i) grid.InsertScan({0., 0.}, points);
  return grid;
}

}  // namespace cartographer::scan_matching

#endif  // TEST_CARTOGRAPHER_SCAN_MATCHING_ROOM_SCENE_H_
