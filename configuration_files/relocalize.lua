-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Defaults of `semantic_kiss relocalize`: semantic KISS-ICP, tied to a map that stays as it is.

include "defaults/run.lua"

-- A vehicle wants to know at once: whatever is due is searched with the scan that brings it.
RUN.pose_graph.optimize_every_n_nodes = 1
RUN.pose_graph.candidates.node_spacing_m = 3.0

return RUN
