-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- semantic_kiss_6dof.lua, but the odometry thins out poles and signs like everything else.

include "semantic_kiss_6dof.lua"

local ODOMETRY = RUN.local_trajectory_builder.semantic_kiss.odometry
for _, stage in ipairs { "map_subsampling", "icp_subsampling", "local_map" } do
  ODOMETRY[stage].max_critical_points_per_voxel = 0
end

return RUN
