-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Options of the local trajectory builder "semantic_kiss": semantic KISS-ICP, submaps. What each
-- option means, its unit and its bounds stand in proto/semantic_kiss/odometry/proto and
-- proto/cartographer/*/proto.

local max_range_m = 100.0
-- KISS-ICP's rule: everything scales with how far the lidar sees.
local voxel_size_m = max_range_m / 100

SEMANTIC_KISS_BUILDER = {
  odometry = {
    mode = "semantic_kiss",
    preprocessing = {
      min_range_m = 0.0,
      max_range_m = max_range_m,
      deskew = true,
      drop_moving = true,
      drop_labels = {},
      label_max_range_m = max_range_m,
    },
    map_subsampling = {
      voxel_size_m = 0.5 * voxel_size_m,
      max_points_per_voxel = 1,
      max_critical_points_per_voxel = 20,
      class_voxels = {},
    },
    icp_subsampling = {
      voxel_size_m = 1.5 * voxel_size_m,
      max_points_per_voxel = 1,
      max_critical_points_per_voxel = 20,
      class_voxels = {},
    },
    local_map = {
      voxel_size_m = voxel_size_m,
      max_points_per_voxel = 20,
      max_critical_points_per_voxel = 20,
      allow_crowding = false,
      displace_unlabeled = false,
    },
    adaptive_threshold = {
      initial_m = 2.0,
      min_model_error_m = 0.1,
      gate_sigmas = 3.0,
      kernel_sigmas = 1.0,
      initial_samples = 1,
      learn_beyond_m = 0.0,
    },
    icp = {
      max_iterations = 500,
      convergence_threshold = 1e-4,
      min_points = 10,
      min_correspondences = 10,
      weight_by_certainty = true,
      unlabeled_weight = 1.0,
      min_lever_arm_m = 0.1,
      agreeing_distance_factor = 1.0,
    },
    restart_after_failures = 5,
    critical_labels = {},
  },
  motion_filter = {
    max_time_s = 5.0,
    max_distance_m = 0.2,
    max_angle_deg = 1.0,
  },
  submaps = {
    scans_per_submap = 20,
    resolution_m = 0.2,
    cloud = {
      voxel_size_m = 1.0,
      max_points_per_voxel = 20,
      max_critical_points_per_voxel = 20,
      allow_crowding = false,
      displace_unlabeled = false,
    },
  },
}
