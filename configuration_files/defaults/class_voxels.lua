-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- For `class_voxels` of a sub-sampling: groups of classes that are thinned apart, so that no wall
-- takes the place of the ground beside it. The sides are SAGE-ICP's for SemanticKITTI.

-- Groups with the sides of their voxels, m, times `factor`. The rest is unlabeled and thinned as ever.
function CLASS_VOXELS(factor)
  local function group(labels, voxel_size_m)
    return { labels = labels, voxel_size_m = factor * voxel_size_m }
  end
  return {
    group({ "road", "parking", "sidewalk", "other-ground" }, 0.6),
    group({ "building", "fence" }, 1.0),
    group({ "vegetation", "terrain" }, 0.9),
    group({ "trunk", "pole", "traffic-sign" }, 0.8),
    group({ "car", "bicycle", "motorcycle", "truck", "other-vehicle" }, 0.6),
  }
end
