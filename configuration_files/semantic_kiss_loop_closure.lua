-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The paper's "Ours (LC)": semantic KISS-ICP, and loops closed in the plane. Heights, roll and
-- pitch stay as the odometry has them.

include "defaults/run.lua"

RUN.pose_graph.optimization.dof = 3

return RUN
