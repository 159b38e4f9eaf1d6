-- Copyright 2026 The Semantic KISS Authors
-- SPDX-License-Identifier: Apache-2.0

-- Defaults of `semantic_kiss simulate`. What each option means, its unit and its bounds stand in
-- proto/semantic_kiss/simulation/proto/simulation_options.proto.
include "simulation_lidars.lua"

return {
  seed = 1,
  epoch = 0,
  route = {
    kind = "city",
    length_m = 800.,
    poses_file = "",
    block_m = 90.,
    ring_m = 500.,
    city_speed_m_per_s = 10.,
    highway_speed_m_per_s = 25.,
    lateral_acceleration_m_per_s2 = 2.5,
    acceleration_m_per_s2 = 1.5,
    highway_threshold_m_per_s = 16.5,
    heave_m = 0.008,
    sway_deg = 0.15,
  },
  world = {
    hill_height_m = 2.5,
    hill_length_m = 160.,
    margin_m = 90.,
    building_density = 1.,
    vegetation_density = 1.,
    furniture_density = 1.,
    parked_vehicle_density = 1.,
    person_density = 1.,
    traffic_density = 1.,
    epoch_change = 0.6,
    wall_relief_m = 0.03,
    road_relief_m = 0.01,
    terrain_relief_m = 0.05,
  },
  lidar = "hdl64",
  lidars = SIMULATION_LIDARS,
  scan_rate_hz = 10.,
  errors = {
    range_noise_m = 0.015,
    dropout = 0.01,
    beam_range_m = 0.012,
    beam_elevation_deg = 0.03,
    beam_azimuth_deg = 0.03,
    directional_elevation_deg = 0.03,
    axis_tilt_deg = 0.02,
    encoder_eccentricity_deg = 0.03,
    bank_range_m = 0.01,
    bank_elevation_deg = 0.02,
    intensity_range_m = 0.03,
    divergence_deg = 0.11,
    incidence_bias = 0.05,
    deskew_residual = 0.03,
    deskew_residual_noise = 0.02,
    range_scale = 0.,
    vertical_angle_deg = 0.205,
  },
  label_noise = {
    share = 0.,
    patch_m = 2.,
    persistence_scans = 10,
    border_factor = 4.,
  },
  raw = false,
}
