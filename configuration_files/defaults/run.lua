-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Everything that a run needs, from which the systems' files (../*.lua) change a few keys.

include "defaults/dataset.lua"
include "defaults/map_image.lua"
include "defaults/planar_builder.lua"
include "defaults/pose_graph.lua"
include "defaults/relocalization.lua"
include "defaults/report.lua"
include "defaults/semantic_kiss_builder.lua"

RUN = {
  label_set = "semantic_kitti",
  dataset = DATASET,
  local_trajectory_builder = {
    name = "semantic_kiss",
    semantic_kiss = SEMANTIC_KISS_BUILDER,
    planar = PLANAR_BUILDER,
  },
  map_image = MAP_IMAGE,
  pose_graph = POSE_GRAPH,
  relocalization = RELOCALIZATION,
  report = REPORT,
}
