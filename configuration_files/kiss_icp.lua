-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The baseline KISS-ICP: labels are carried into the map, but decide nothing.

include "defaults/run.lua"

RUN.local_trajectory_builder.semantic_kiss.odometry.mode = "kiss_icp"
-- Odometry alone.
RUN.pose_graph.optimize_every_n_nodes = 0

return RUN
