-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- How sequences in SemanticKITTI's format are read. What each option means, its unit and its bounds
-- stand in proto/semantic_kiss/dataset/proto/dataset_options.proto.

DATASET = {
  vertical_correction_deg = 0.205,  -- KITTI's; 0 for scans of other lidars
  assumed_rate_hz = 10.0,
  confidences_dir = "confidences",
  -- The 20 classes of SemanticKITTI's single-scan benchmark, in the order in which networks that
  -- are trained for it number them.
  confidence_columns = {
    0, 10, 11, 15, 18, 20, 30, 31, 32, 40, 44, 48, 49, 50, 51, 70, 71, 72, 80, 81,
  },
  moving_masks_dir = "",
}
