-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- semantic_kiss_6dof.lua, but pairs of the odometry count the same whatever their labels are.

include "semantic_kiss_6dof.lua"

RUN.local_trajectory_builder.semantic_kiss.odometry.icp.weight_by_certainty = false

return RUN
