-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Loop closure. What each option means, its unit and its bounds stand in
-- proto/cartographer/pose_graph/proto.

include "defaults/closure_verification.lua"
include "defaults/optimization.lua"
include "defaults/place_recognition.lua"
include "defaults/scan_matching.lua"

POSE_GRAPH = {
  optimize_every_n_nodes = 100,
  candidates = {
    node_spacing_m = 4.0,
    -- The odometry's own map reaches as far: nothing nearer can be told better than it was.
    min_travel_m = 100.0,
    max_distance_m = 12.0,
    max_nearby = 3,
    window = {
      linear_m = 2.0,
      linear_m_per_m = 0.015,
      angular_deg = 3.0,
      angular_deg_per_m = 0.01,
      max_linear_m = 25.0,
      max_angular_deg = 20.0,
    },
    max_places = 5,
    place_window_above_m = 6.0,
    place_linear_m = 8.0,
    place_angular_deg = 12.0,
    search_all = {
      after_nodes = 0,
      linear_m = 16.0,
      max_points = 1000,
      min_score = 0.4,
    },
  },
  place_recognition = PLACE_RECOGNITION,
  scan_matching = SCAN_MATCHING,
  min_score = 0.25,
  verify_in = "space",
  planar_closure = { sigma_m = 0.1, sigma_deg = 0.3 },
  verification = CLOSURE_VERIFICATION,
  joined_neighbours = 1,
  agreement = {
    min_agreeing = 1,
    max_travel_m = 30.0,
    max_distance_m = 0.5,
    max_distance_m_per_m = 0.02,
    max_angle_deg = 1.0,
  },
  optimization = OPTIMIZATION,
}
