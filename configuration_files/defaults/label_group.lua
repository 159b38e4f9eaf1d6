-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- A message LabelGroup (proto/cartographer/scan_matching/proto/scan_matching_options.proto).

function LABEL_GROUP(name, roles, weight, saturation_hits, apart)
  return {
    name = name,
    labels = {},
    roles = roles,
    weight = weight,
    saturation_hits = saturation_hits,
    apart = apart,
  }
end
