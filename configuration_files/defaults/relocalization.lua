-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Localization in a finished map. What each option means, its unit and its bounds stand in
-- proto/cartographer/slam/proto/relocalization_options.proto.

RELOCALIZATION = {
  lost_after_nodes = 4,
  keep_m = 80.0,
  initial_pose_path_m = 400.0,
}
