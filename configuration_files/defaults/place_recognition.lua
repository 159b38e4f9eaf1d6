-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Recognition of places that were seen before. What each option means, its unit and its bounds
-- stand in proto/cartographer/pose_graph/proto/place_recognition_options.proto. Groups go by roles,
-- not by names, so that they serve every label set.

local function group(name, roles, weight, saturation_hits, apart)
  return {
    name = name,
    labels = {},
    roles = roles,
    weight = weight,
    saturation_hits = saturation_hits,
    apart = apart,
  }
end

PLACE_RECOGNITION = {
  groups = {
    group("moving", { "moving" }, 0.0, 1, false),
    -- Others may be parked there the next time.
    group("movable", { "movable" }, 0.0, 1, false),
    group("critical", { "critical" }, 1.0, 1, false),
    group("ground", { "ground" }, 1.0, 4, true),
    group("unlabeled", { "unlabeled" }, 1.0, 4, false),
    -- The rest: buildings, fences, vegetation, trunks.
    group("structure", {}, 1.0, 4, true),
  },
  radius_m = 50.0,
  num_rings = 12,
  num_harmonics = 16,
}
