-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Matching of scans with the grids of submaps. What each option means, its unit and its bounds
-- stand in proto/cartographer/scan_matching/proto/scan_matching_options.proto. Groups go by roles,
-- not by names, so that they serve every label set.

include "defaults/label_group.lua"

SCAN_MATCHING = {
  score = {
    score = "dominant_label",
    partial_agreement = 0.0,
    groups = {
      LABEL_GROUP("moving", { "moving" }, 0.0, 1, false),
      -- Few points, but they tell one place from another.
      LABEL_GROUP("critical", { "critical" }, 3.0, 10, false),
      -- May have left since, or another one may stand there.
      LABEL_GROUP("movable", { "movable" }, 0.5, 10, false),
      -- Everywhere, so that only its borders say where the scan was taken.
      LABEL_GROUP("ground", { "ground" }, 0.25, 5, true),
      LABEL_GROUP("unlabeled", { "unlabeled" }, 0.25, 10, false),
      -- The rest: buildings, fences, vegetation, trunks.
      LABEL_GROUP("structure", {}, 1.0, 10, true),
    },
    max_range_m = 60.0,
  },
  cache_mib = 256.0,
  refinement = {
    max_iterations = 20,
    function_tolerance = 1e-4,
    max_translation_m = 0.6,
    max_rotation_deg = 2.0,
  },
}
