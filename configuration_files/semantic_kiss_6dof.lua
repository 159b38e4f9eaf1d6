-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Semantic KISS-ICP, and loops closed in all six degrees of freedom: the drift in height goes, too.

include "defaults/run.lua"

RUN.pose_graph.optimization.dof = 6

return RUN
