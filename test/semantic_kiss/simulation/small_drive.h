// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_SEMANTIC_KISS_SIMULATION_SMALL_DRIVE_H_
#define TEST_SEMANTIC_KISS_SIMULATION_SMALL_DRIVE_H_

#include <memory>
#include <string>

#include "semantic_kiss/simulation/simulation.h"

namespace semantic_kiss::simulation {

// The shipped options with a lidar of 16 x 300 rays and a short route, after the Lua statements
// `overrides`, which may name them as `options`. CHECK-fails on errors.
proto::SimulationOptions SmallOptions(const std::string& overrides = "");

// Overrides that leave out every error of the sensor.
extern const char kNoErrors[];
// Overrides that leave out all that moves or may be moved.
extern const char kNothingMovable[];

std::unique_ptr<Simulation> SmallDrive(const std::string& overrides = "");

}  // namespace semantic_kiss::simulation

#endif  // TEST_SEMANTIC_KISS_SIMULATION_SMALL_DRIVE_H_
