-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- `semantic_kiss relocalize` with a lidar that scans a plane indoors, in a map of occupancy such as
-- Cartographer's own: no labels, no points of the map, and no places to be recognized by them.

include "relocalize.lua"

local builder = RUN.local_trajectory_builder.semantic_kiss
local odometry = builder.odometry
-- Walls are near and thin, and scans have hundreds of points, not a hundred thousand.
odometry.preprocessing.min_range_m = 0.3
odometry.preprocessing.max_range_m = 30.0
odometry.preprocessing.deskew = false
odometry.map_subsampling.voxel_size_m = 0.05
odometry.icp_subsampling.voxel_size_m = 0.05
odometry.local_map.voxel_size_m = 0.25
odometry.adaptive_threshold.initial_m = 0.5
odometry.adaptive_threshold.min_model_error_m = 0.03
builder.motion_filter.max_distance_m = 0.1
builder.submaps.scans_per_submap = 20
builder.submaps.resolution_m = 0.05
builder.submaps.cloud.voxel_size_m = 0.25
-- Such a lidar scans its own plane: there is no error of KITTI's to correct.
RUN.dataset.vertical_correction_deg = 0.0

local graph = RUN.pose_graph
graph.verify_in = "plane"
graph.scan_matching.score.score = "occupancy"
graph.scan_matching.score.max_range_m = 20.0
graph.optimization.dof = 3
graph.candidates.node_spacing_m = 1.0
graph.candidates.max_places = 0
graph.candidates.search_all.after_nodes = 1
graph.candidates.search_all.linear_m = 8.0
graph.candidates.search_all.min_score = 0.45

return RUN
