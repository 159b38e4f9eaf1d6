-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0
--
-- The 32 general classes of nuScenes-lidarseg (its files hold one uint8 a point; the ids are the
-- same whatever holds them). docs/labels.md explains the fields. Predictions for nuScenes' 16
-- challenge classes are numbered otherwise (0..16) and need a label set of their own.
--
-- Merges follow the 16 challenge classes where these join kinds of the same thing. Classes that the
-- challenge ignores keep their own label: ignored is not the same as unknown.
--
-- Roles:
--  * The labels do not tell moving from parked. Vehicles are movable: most points are of parked
--    ones. People and animals are moving: they mostly walk, and give up few points. The car's own
--    returns (vehicle.ego) travel with the sensor, so they are moving as well.
--  * static.manmade is walls, poles and signs in one: sparing it from sub-sampling would spare
--    nearly everything, so that no class is critical.

local function class(id, name, color, roles, merged_into)
  return { id = id, name = name, color = color, roles = roles or {}, merged_into = merged_into }
end

local UNLABELED = { "unlabeled" }
local MOVABLE = { "movable" }
local MOVING = { "moving" }
local GROUND = { "ground" }

return {
  name = "nuscenes",

  -- Below 1 for the reason that semantic_kitti.lua gives.
  default_certainty = 0.9,

  classes = {
    class(0, "noise", { 175, 175, 175 }, UNLABELED),
    class(1, "animal", { 190, 120, 150 }, MOVING),
    class(2, "human.pedestrian.adult", { 255, 60, 110 }, MOVING),
    class(3, "human.pedestrian.child", { 255, 90, 140 }, MOVING, "human.pedestrian.adult"),
    class(4, "human.pedestrian.construction_worker", { 230, 60, 140 }, MOVING,
          "human.pedestrian.adult"),
    class(5, "human.pedestrian.personal_mobility", { 200, 60, 170 }, MOVING),
    class(6, "human.pedestrian.police_officer", { 200, 30, 110 }, MOVING,
          "human.pedestrian.adult"),
    class(7, "human.pedestrian.stroller", { 230, 100, 190 }, MOVING),
    class(8, "human.pedestrian.wheelchair", { 180, 50, 130 }, MOVING),
    class(9, "movable_object.barrier", { 240, 110, 50 }, MOVABLE),
    class(10, "movable_object.debris", { 150, 120, 100 }, MOVABLE),
    class(11, "movable_object.pushable_pullable", { 170, 140, 60 }, MOVABLE),
    class(12, "movable_object.trafficcone", { 255, 80, 0 }, MOVABLE),
    class(13, "static_object.bicycle_rack", { 100, 130, 140 }),
    class(14, "vehicle.bicycle", { 70, 190, 225 }, MOVABLE),
    class(15, "vehicle.bus.bendy", { 40, 100, 200 }, MOVABLE, "vehicle.bus.rigid"),
    class(16, "vehicle.bus.rigid", { 20, 70, 180 }, MOVABLE),
    class(17, "vehicle.car", { 60, 120, 240 }, MOVABLE),
    class(18, "vehicle.construction", { 120, 100, 220 }, MOVABLE),
    class(19, "vehicle.emergency.ambulance", { 120, 160, 250 }, MOVABLE),
    class(20, "vehicle.emergency.police", { 90, 90, 255 }, MOVABLE),
    class(21, "vehicle.motorcycle", { 30, 60, 150 }, MOVABLE),
    class(22, "vehicle.trailer", { 110, 60, 160 }, MOVABLE),
    class(23, "vehicle.truck", { 85, 40, 190 }, MOVABLE),
    class(24, "flat.driveable_surface", { 205, 125, 205 }, GROUND),
    class(25, "flat.other", { 165, 20, 90 }, GROUND),
    class(26, "flat.sidewalk", { 100, 30, 110 }, GROUND),
    class(27, "flat.terrain", { 150, 205, 90 }, GROUND),
    class(28, "static.manmade", { 235, 165, 20 }),
    class(29, "static.other", { 140, 130, 120 }),
    class(30, "static.vegetation", { 50, 160, 60 }),
    class(31, "vehicle.ego", { 60, 60, 60 }, MOVING),
  },
}
