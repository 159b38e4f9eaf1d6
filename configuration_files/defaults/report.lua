-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The map in report.html, and what `render --output=X.html` writes. What each option means, its unit
-- and its bounds stand in proto/semantic_kiss/report/proto/report_options.proto.

REPORT = {
  resolution_m = 0.0,
  max_side_px = 3000,
  max_pictures_mb = 9.0,
  tile_side_px = 512,
}
