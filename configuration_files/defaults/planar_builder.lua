-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Options of the local trajectory builder "planar": Cartographer's way in the plane. What each
-- option means, its unit and its bounds stand in proto/cartographer/{slam,scan_matching,submap}/proto.
-- Heights are for a lidar on the roof of a car, 1.7 m above the road.

-- The range of the other systems: far walls are what holds the heading.
local max_range_m = 100.0

PLANAR_BUILDER = {
  height_band = {
    min_range_m = 2.5,
    max_range_m = max_range_m,
    min_z_m = -1.0,
    max_z_m = 2.5,
    voxel_size_m = 0.1,
  },
  matched_points = {
    max_range_m = max_range_m,
    max_voxel_size_m = 0.5,
    min_points = 2500,
  },
  min_points = 50,
  -- A car that turns in jumps 2.5 degrees a scan away from constant velocity. A fit that begins there
  -- ends in a wrong minimum, which the next guess then repeats.
  correlative_search = {
    enabled = true,
    window_m = 0.3,
    window_deg = 4.0,
    translation_penalty_per_m = 0.1,
    rotation_penalty_per_deg = 0.01,
    max_points = 400,
  },
  initial_search = {
    enabled = true,
    window_m = 4.0,
    window_deg = 3.0,
    translation_penalty_per_m = 0.0,
    rotation_penalty_per_deg = 0.0,
    max_points = 2500,
  },
  fit = {
    occupied_space_weight = 1.0,
    translation_weight_per_m = 1.0,
    rotation_weight_per_rad = 1.0,
    max_iterations = 20,
    function_tolerance = 1e-6,
  },
  motion_filter = {
    max_time_s = 5.0,
    max_distance_m = 0.2,
    max_angle_deg = 1.0,
  },
  submaps = {
    scans_per_submap = 80,
    grid = {
      resolution_m = 0.1,
      hit_probability = 0.55,
      miss_probability = 0.49,
      cast_rays = true,
    },
    cloud = {
      voxel_size_m = 1.0,
      max_points_per_voxel = 20,
      max_critical_points_per_voxel = 20,
      allow_crowding = false,
      displace_unlabeled = false,
    },
  },
}
