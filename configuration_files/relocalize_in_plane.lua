-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- `semantic_kiss relocalize` with a lidar that scans a plane, in a map of occupancy such as
-- Cartographer's own: no labels, no points of the map, and no places to be recognized by them.

include "relocalize.lua"

local builder = RUN.local_trajectory_builder
builder.name = "planar"
-- Indoors: walls are near, and the scans of such lidars have hundreds of points.
builder.planar.height_band.min_range_m = 0.3
builder.planar.height_band.voxel_size_m = 0.05
builder.planar.matched_points.min_points = 100
builder.planar.min_points = 20
builder.planar.submaps.scans_per_submap = 40
builder.planar.submaps.grid.resolution_m = 0.05
-- Such a lidar scans its own plane: there is no error of KITTI's to correct.
RUN.dataset.vertical_correction_deg = 0.0

local graph = RUN.pose_graph
graph.verify_in = "plane"
graph.scan_matching.score.score = "occupancy"
graph.optimization.dof = 3
graph.candidates.node_spacing_m = 1.0
graph.candidates.max_places = 0
graph.candidates.search_all.after_nodes = 3
graph.candidates.search_all.linear_m = 8.0
graph.scan_matching.score.max_range_m = 20.0

return RUN
