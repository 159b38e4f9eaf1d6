-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- semantic_kiss_6dof.lua, but the odometry thins each group of classes by itself, as SAGE-ICP does.

include "semantic_kiss_6dof.lua"
include "defaults/class_voxels.lua"

local ODOMETRY = RUN.local_trajectory_builder.semantic_kiss.odometry
for subsampling, factor in pairs { map_subsampling = 0.5, icp_subsampling = 1.5 } do
  ODOMETRY[subsampling].class_voxels = CLASS_VOXELS(factor)
end

return RUN
