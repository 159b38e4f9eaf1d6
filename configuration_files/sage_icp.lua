-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The baseline SAGE-ICP (Cui, Chen, Li: "SAGE-ICP: Semantic Information-Assisted ICP", ICRA 2024),
-- with the constants that its authors use for SemanticKITTI's labels. Where it differs from
-- KISS-ICP and from ours: docs/systems.md.

include "defaults/run.lua"
include "defaults/class_voxels.lua"

local ODOMETRY = RUN.local_trajectory_builder.semantic_kiss.odometry

ODOMETRY.preprocessing.min_range_m = 5.0
ODOMETRY.preprocessing.label_max_range_m = 50.0
-- Who may walk or ride away; what is seen to move goes by its role.
ODOMETRY.preprocessing.drop_labels = { "person", "bicyclist", "motorcyclist" }

-- What is in no group of classes is unlabeled.
local rest_m = 1.0
for subsampling, factor in pairs { map_subsampling = 0.5, icp_subsampling = 1.5 } do
  ODOMETRY[subsampling].voxel_size_m = factor * rest_m
  ODOMETRY[subsampling].class_voxels = CLASS_VOXELS(factor)
  ODOMETRY[subsampling].max_critical_points_per_voxel = 0
end

ODOMETRY.local_map = {
  voxel_size_m = 0.8,
  max_points_per_voxel = 20,
  max_critical_points_per_voxel = 20,
  allow_crowding = true,
  displace_unlabeled = true,
}
-- What stands out of the ground, the walls and the green.
ODOMETRY.critical_labels = {
  "fence", "trunk", "pole", "traffic-sign",
  "car", "bicycle", "motorcycle", "truck", "other-vehicle",
}

ODOMETRY.adaptive_threshold.kernel_sigmas = 1 / 3
ODOMETRY.adaptive_threshold.initial_samples = 0
ODOMETRY.adaptive_threshold.learn_beyond_m = 0.5

ODOMETRY.icp.weight_by_certainty = false
ODOMETRY.icp.agreeing_distance_factor = 0.05

-- Odometry alone.
RUN.pose_graph.optimize_every_n_nodes = 0

return RUN
