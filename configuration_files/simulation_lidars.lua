-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0

-- Lidars that `semantic_kiss simulate --lidar=NAME` can drive with.
SIMULATION_LIDARS = {
  {
    -- Like KITTI's Velodyne HDL-64E: two banks of 32 beams, the upper one twice as dense.
    name = "hdl64",
    banks = {
      { beams = 32, first_elevation_deg = 2.0, last_elevation_deg = -8.5 },
      { beams = 32, first_elevation_deg = -8.9, last_elevation_deg = -24.8 },
    },
    columns = 2150,
    min_range_m = 1.5,
    max_range_m = 80.,
    mount_height_m = 1.73,
    half_return_range_m = 70.,
    hidden_by_car = true,
  },
  {
    -- Like an Ouster OS1-128.
    name = "os1_128",
    banks = {
      { beams = 128, first_elevation_deg = 22.5, last_elevation_deg = -22.5 },
    },
    columns = 1024,
    min_range_m = 0.8,
    max_range_m = 120.,
    mount_height_m = 1.8,
    half_return_range_m = 60.,
    hidden_by_car = false,
  },
  {
    -- Like a Velodyne VLP-16.
    name = "vlp16",
    banks = {
      { beams = 16, first_elevation_deg = 15., last_elevation_deg = -15. },
    },
    columns = 1800,
    min_range_m = 0.9,
    max_range_m = 100.,
    mount_height_m = 1.8,
    half_return_range_m = 60.,
    hidden_by_car = false,
  },
}
