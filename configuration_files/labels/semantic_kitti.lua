-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The classes of SemanticKITTI; docs/labels.md explains the fields.
--
-- Merges follow the usual 19 classes, with one exception: there, moving classes are folded into
-- static ones. Here they stay apart, because what moves must be dropped and what is parked must
-- not; so the moving classes merge among themselves, as in the 25 classes of the multi-scan task.
--
-- Roles:
--  * People and riders are movable, not moving: who stands still holds the pose as well as a parked
--    car does, and will be gone tomorrow as well. A network of 19 classes labels walking people so
--    too; they are a few points.
--  * other-structure and other-object are unlabeled, as in the 19 classes: they collect what has no
--    name (walls, bins, benches), so that an equal label there says nothing.
--  * Trunks and building corners are as rigid as poles, but not rare: not critical.
--
-- Colours are for a light background: the hues of the usual palette, with its lightest ones (pole,
-- terrain, road) made darker and what matters most in a map kept far apart.

local function class(id, name, color, roles, merged_into)
  return { id = id, name = name, color = color, roles = roles or {}, merged_into = merged_into }
end

local UNLABELED = { "unlabeled" }
local MOVABLE = { "movable" }
local MOVING = { "moving" }
local GROUND = { "ground" }
local CRITICAL = { "critical" }

return {
  name = "semantic_kitti",

  -- For scans without certainties of their own: annotators' labels, or a network that gave none.
  -- Not 1: a pair whose labels differ weighs 1 - certainty, so that at 1 it is rejected outright.
  -- But labels differ for honest reasons as well: along every border between classes, where road
  -- meets parking, in objects that the annotators judged one way in one scan and otherwise in the
  -- next. At 0.9 such pairs weigh a ninth of the others: they yield wherever there is better, and
  -- still hold the pose where there is not.
  default_certainty = 0.9,

  classes = {
    class(0, "unlabeled", { 175, 175, 175 }, UNLABELED),
    class(1, "outlier", { 200, 200, 200 }, UNLABELED),
    -- What moving-object masks say of a point that does not move: nothing about what it is.
    class(9, "static", { 190, 190, 190 }, UNLABELED),

    class(10, "car", { 60, 120, 240 }, MOVABLE),
    class(11, "bicycle", { 70, 190, 225 }, MOVABLE),
    class(13, "bus", { 70, 80, 250 }, MOVABLE, "other-vehicle"),
    class(15, "motorcycle", { 30, 60, 150 }, MOVABLE),
    class(16, "on-rails", { 0, 0, 200 }, MOVABLE, "other-vehicle"),
    class(18, "truck", { 85, 40, 190 }, MOVABLE),
    class(20, "other-vehicle", { 20, 20, 255 }, MOVABLE),
    class(30, "person", { 255, 60, 110 }, MOVABLE),
    class(31, "bicyclist", { 255, 40, 200 }, MOVABLE),
    class(32, "motorcyclist", { 150, 30, 90 }, MOVABLE),

    class(40, "road", { 205, 125, 205 }, GROUND),
    class(44, "parking", { 240, 170, 215 }, GROUND),
    class(48, "sidewalk", { 100, 30, 110 }, GROUND),
    class(49, "other-ground", { 165, 20, 90 }, GROUND),
    class(50, "building", { 235, 165, 20 }),
    class(51, "fence", { 240, 110, 50 }),
    class(52, "other-structure", { 215, 185, 150 }, UNLABELED),
    class(60, "lane-marking", { 120, 215, 150 }, GROUND, "road"),
    class(70, "vegetation", { 50, 160, 60 }),
    class(71, "trunk", { 125, 60, 10 }),
    class(72, "terrain", { 150, 205, 90 }, GROUND),
    class(80, "pole", { 25, 25, 40 }, CRITICAL),
    class(81, "traffic-sign", { 220, 0, 0 }, CRITICAL),
    class(99, "other-object", { 130, 195, 195 }, UNLABELED),

    -- What moving-object masks say of a point that moves.
    class(251, "moving", { 255, 0, 160 }, MOVING),
    class(252, "moving-car", { 60, 120, 240 }, MOVING),
    class(253, "moving-bicyclist", { 255, 40, 200 }, MOVING),
    class(254, "moving-person", { 255, 60, 110 }, MOVING),
    class(255, "moving-motorcyclist", { 150, 30, 90 }, MOVING),
    class(256, "moving-on-rails", { 0, 0, 200 }, MOVING, "moving-other-vehicle"),
    class(257, "moving-bus", { 70, 80, 250 }, MOVING, "moving-other-vehicle"),
    class(258, "moving-truck", { 85, 40, 190 }, MOVING),
    class(259, "moving-other-vehicle", { 20, 20, 255 }, MOVING),
  },
}
