-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Semantic KISS-ICP over labeled scans in SemanticKITTI's format. "semantic_kiss config" prints
-- what all of this resolves to.

include "defaults/run.lua"
-- Odometry alone.
RUN.pose_graph.optimize_every_n_nodes = 0

return RUN
