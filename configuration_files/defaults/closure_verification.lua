-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Verification of loop closures: from a match in the plane to a constraint in six degrees of freedom.
-- What each option means, its unit and its bounds stand in
-- proto/cartographer/pose_graph/proto/verification_options.proto; docs/loop_closure.md says how the
-- thresholds were chosen.

CLOSURE_VERIFICATION = {
  target = {
    voxel_size_m = 1.0,
    max_points_per_voxel = 20,
    max_critical_points_per_voxel = 20,
    allow_crowding = false,
    displace_unlabeled = false,
  },
  icp = {
    max_iterations = 50,
    convergence_threshold = 1e-3,
    min_points = 100,
    min_correspondences = 50,
    weight_by_certainty = true,
    unlabeled_weight = 1.0,
    min_lever_arm_m = 0.1,
    agreeing_distance_factor = 1.0,
  },
  stages = {
    { gate_m = 2.0, kernel_scale = 0.5 },
    { gate_m = 0.6, kernel_scale = 0.1 },
  },
  ground = {
    cell_m = 1.0,
    max_range_m = 30.0,
    min_points = 30,
  },
  acceptance = {
    max_range_m = 50.0,
    min_points = 100,
    overlap_distance_m = 1.0,
    min_overlap = 0.6,
    inlier_distance_m = 0.4,
    min_inlier_ratio = 0.6,
    max_rms_error_m = 0.3,
    max_correction_m = 1.0,
    max_correction_deg = 4.0,
    max_height_mismatch_m = 0.2,
    max_sigma_m = 0.5,
    max_sigma_deg = 1.0,
  },
  information = {
    point_sigma_m = 0.1,
    pairs_per_measurement = 50.0,
    floor_sigma_m = 0.03,
    floor_sigma_deg = 0.1,
    prior_sigma_m = 1.0,
    prior_sigma_deg = 5.0,
  },
}
