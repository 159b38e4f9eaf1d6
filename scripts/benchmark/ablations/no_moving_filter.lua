-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- semantic_kiss_6dof.lua, but the odometry keeps what is labeled as moving.

include "semantic_kiss_6dof.lua"

RUN.local_trajectory_builder.semantic_kiss.odometry.preprocessing.drop_moving = false

return RUN
