// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// How many rays a second the simulator casts with one thread: the HDL-64's through a town, by what
// the scan goes on with. scripts/microbenchmark.sh builds and runs it; docs/benchmarks.md has
// figures.

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "cartographer/common/options_loader.h"
#include "glog/logging.h"
#include "semantic_kiss/simulation/simulation.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::simulation {
namespace {

std::unique_ptr<Simulation> Drive(const std::string& overrides) {
  const std::string source =
      "local options = include \"simulation.lua\"\n" + overrides + "\nreturn options\n";
  proto::SimulationOptions options;
  const absl::Status status = cartographer::common::LoadOptionsFromString(
      source, "options of a benchmark", {semantic_kiss_testing::SourceFile("configuration_files")},
      &options);
  CHECK(status.ok()) << status;
  auto drive = Simulation::Create(options);
  CHECK(drive.ok()) << drive.status();
  return *std::move(drive);
}

// Scans all along a drive, far enough apart to see other things.
void BM_Scan(benchmark::State& state, const std::string& overrides) {
  const std::unique_ptr<Simulation> drive = Drive(overrides);
  int scan = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(drive->Scan(scan % drive->num_scans()).data());
    scan += 37;
  }
  const double rays = static_cast<double>(drive->lidar().beams()) * drive->lidar().columns();
  state.counters["rays"] = benchmark::Counter(rays * static_cast<double>(state.iterations()),
                                              benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(BM_Scan, city, std::string())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Scan, city_with_label_noise, std::string("options.label_noise.share = 0.06"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Scan, highway, std::string("options.route.kind = 'highway'"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Scan, os1_128, std::string("options.lidar = 'os1_128'"))
    ->Unit(benchmark::kMillisecond);

void BM_BuildTown(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Drive("").get());
}
BENCHMARK(BM_BuildTown)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace semantic_kiss::simulation

BENCHMARK_MAIN();
