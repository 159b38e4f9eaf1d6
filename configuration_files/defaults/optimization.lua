-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Optimization of the pose graph. What each option means, its unit and its bounds stand in
-- proto/cartographer/pose_graph/proto/optimization_options.proto; how the values were found in
-- docs/decisions/0007-odometry-errors-are-random-and-systematic.md.

local function sigmas(forward_m, left_m, up_m, tilt_deg, heading_deg)
  return {
    forward_m = forward_m,
    left_m = left_m,
    up_m = up_m,
    tilt_deg = tilt_deg,
    heading_deg = heading_deg,
  }
end

OPTIMIZATION = {
  dof = 6,
  odometry = {
    random = sigmas(0.01, 0.01, 0.01, 0.01, 0.005),
    min_step_m = 0.1,
    -- Loops cannot tell how long a metre is, but how the sensor is mounted.
    systematic = sigmas(0.0, 0.002, 0.001, 0.001, 0.001),
  },
  submap_tie = sigmas(0.02, 0.02, 0.02, 0.05, 0.05),
  loop_scale_sigmas = 4.0,
  max_iterations = 100,
}
