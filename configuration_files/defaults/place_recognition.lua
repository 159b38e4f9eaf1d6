-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Recognition of places that were seen before. What each option means, its unit and its bounds
-- stand in proto/cartographer/pose_graph/proto/place_recognition_options.proto. Groups go by roles,
-- not by names, so that they serve every label set.

include "defaults/label_group.lua"

PLACE_RECOGNITION = {
  groups = {
    LABEL_GROUP("moving", { "moving" }, 0.0, 1, false),
    -- Others may be parked there the next time.
    LABEL_GROUP("movable", { "movable" }, 0.0, 1, false),
    LABEL_GROUP("critical", { "critical" }, 1.0, 4, false),
    -- The lanes look alike everywhere.
    LABEL_GROUP("ground", { "ground" }, 0.0, 1, false),
    LABEL_GROUP("unlabeled", { "unlabeled" }, 1.0, 4, false),
    -- The rest: buildings, fences, vegetation, trunks.
    LABEL_GROUP("structure", {}, 1.0, 4, true),
  },
  min_height_m = 0.5,
  cell_m = 2.0,
  blur_m = 3.0,
  radius_m = 56.0,
  num_rings = 8,
  num_harmonics = 8,
  num_shifts = 1,
  shift_m = 6.0,
}
