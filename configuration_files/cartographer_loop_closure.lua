-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The baseline Cartographer with its loop closure: scans are matched by occupancy with the submaps
-- that the estimate finds nearby, matches count as they are, poses are optimized in the plane. Labels
-- decide nothing.

include "defaults/run.lua"

RUN.local_trajectory_builder.name = "planar"

local POSE_GRAPH = RUN.pose_graph

-- Within a drive Cartographer relies on the estimate alone, with a window that does not grow. Submaps
-- of 80 scans are long.
local CANDIDATES = POSE_GRAPH.candidates
CANDIDATES.max_distance_m = 25.0
CANDIDATES.max_places = 0
CANDIDATES.window = {
  linear_m = 7.0,
  linear_m_per_m = 0.0,
  angular_deg = 10.0,
  angular_deg_per_m = 0.0,
  max_linear_m = 7.0,
  max_angular_deg = 10.0,
}

POSE_GRAPH.scan_matching.score.score = "occupancy"
POSE_GRAPH.min_score = 0.55
POSE_GRAPH.verify_in = "plane"
POSE_GRAPH.optimization.dof = 3
-- Cartographer knows no errors that are the same all along a drive.
local SYSTEMATIC = POSE_GRAPH.optimization.odometry.systematic
for component in pairs(SYSTEMATIC) do SYSTEMATIC[component] = 0.0 end

return RUN
