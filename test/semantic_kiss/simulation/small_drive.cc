// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/semantic_kiss/simulation/small_drive.h"

#include "cartographer/common/options_loader.h"
#include "glog/logging.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::simulation {

const char kNoErrors[] =
    "for name in pairs(options.errors) do options.errors[name] = 0. end\n"
    "options.errors.wander_s = 30.\n";
const char kNothingMovable[] =
    "options.world.parked_vehicle_density = 0.\n"
    "options.world.person_density = 0.\n"
    "options.world.traffic_density = 0.\n";

proto::SimulationOptions SmallOptions(const std::string& overrides) {
  const std::string source =
      "local options = include \"simulation.lua\"\n"
      "options.route.length_m = 60.\n"
      "options.world.margin_m = 40.\n"
      "options.lidar = \"small\"\n"
      "options.lidars = {{ name = \"small\", banks = {{ beams = 16, first_elevation_deg = 2., "
      "last_elevation_deg = -24. }}, columns = 300, min_range_m = 1., max_range_m = 60., "
      "mount_height_m = 1.73, half_return_range_m = 60., hidden_by_car = false }}\n" +
      overrides + "\nreturn options\n";
  proto::SimulationOptions options;
  const absl::Status status = cartographer::common::LoadOptionsFromString(
      source, "overrides of a test", {semantic_kiss_testing::SourceFile("configuration_files")},
      &options);
  CHECK(status.ok()) << status;
  return options;
}

std::unique_ptr<Simulation> SmallDrive(const std::string& overrides) {
  auto drive = Simulation::Create(SmallOptions(overrides));
  CHECK(drive.ok()) << drive.status();
  return *std::move(drive);
}

}  // namespace semantic_kiss::simulation
