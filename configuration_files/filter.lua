-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- Defaults of `semantic_kiss filter`, whose flags change them. A file of one's own may do so, too:
--
--   include "defaults/map_filter.lua"
--   MAP_FILTER.remove_roles = { "movable" }
--   return MAP_FILTER

include "defaults/map_filter.lua"

return MAP_FILTER
