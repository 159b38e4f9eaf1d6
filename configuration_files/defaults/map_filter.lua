-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- What `semantic_kiss filter` takes out of a map. What each option means, its unit and its bounds
-- stand in proto/cartographer/map/proto/filter_options.proto.

MAP_FILTER = {
  remove = {},
  remove_roles = {},
  keep = {},
  keep_roles = {},
  polygon = {},
  box = {},
  outside = false,
  trajectories = {},
  keep_trajectories = {},
  min_hits = 0,
  remove_transient = false,
  transient = {
    min_time_between_visits_s = 30.0,
    tolerance_m = 0.4,
    min_ground_hits = 2,
    max_movable_share = 0.05,
    max_height_difference_m = 3.0,
  },
}
