-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The baseline Cartographer (Hess et al., "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016):
-- scans without ground, matched with grids of probabilities in the plane. Labels decide nothing.

include "defaults/run.lua"

RUN.local_trajectory_builder.name = "planar"
-- Odometry alone.
RUN.pose_graph.optimize_every_n_nodes = 0

return RUN
