-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The picture of the map, and what else `render` makes of it. What each option means, its unit and its bounds stand in
-- proto/cartographer/io/proto/render_options.proto.

MAP_IMAGE = {
  resolution_m = 0.0,
  max_side_px = 4000,
  crop_share = 0.01,
  fill_gaps_m = 1.5,
  hide = {},
  show = {},
  draw_trajectory = true,
  draw_loop_closures = true,
  draw_frame = true,
  title = "",
  cloud_resolution_m = 0.1,
}
