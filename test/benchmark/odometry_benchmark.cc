// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// How long the odometry and the submaps take, whole and by stage, on real scans if there are any.
// scripts/microbenchmark.sh builds and runs it; docs/benchmarks.md has figures.

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "cartographer/submap/active_submaps.h"
#include "semantic_kiss/odometry/odometry.h"
#include "semantic_kiss/odometry/voxel_subsampling.h"
#include "tbb/global_control.h"
#include "test/testing/odometry_on_sequence.h"
#include "test/testing/test_files.h"
#include "test/testing/test_sequence.h"

namespace semantic_kiss {
namespace {

using cartographer::sensor::LabeledScan;
using cartographer::sensor::LabelRole;
using cartographer::sensor::LabelSet;

// The 16 labeled scans, else a made-up street: figures of the two cannot be compared.
const std::vector<LabeledScan>& Scans() {
  static const auto* const scans = [] {
    const auto data = semantic_kiss_testing::RealDataDirectory();
    if (data.has_value()) {
      return new std::vector<LabeledScan>(
          semantic_kiss_testing::ReadScans(*data + "/semantickitti"));
    }
    const semantic_kiss_testing::TemporaryDirectory directory;
    semantic_kiss_testing::WriteTestSequence(directory.path(), {});
    return new std::vector<LabeledScan>(semantic_kiss_testing::ReadScans(directory.path()));
  }();
  return *scans;
}

const LabelSet& Labels() {
  static const auto* const labels = new LabelSet(semantic_kiss_testing::ShippedLabels());
  return *labels;
}

void ReportPerScan(benchmark::State& state) {
  const double num_scans = static_cast<double>(Scans().size()) * state.iterations();
  state.counters["s_per_scan"] =
      benchmark::Counter(num_scans, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// All scans through a new odometry.
void BM_Odometry(benchmark::State& state, const std::string& mode) {
  const auto options =
      semantic_kiss_testing::ShippedOptions("options.odometry.mode = '" + mode + "'").odometry();
  Scans();
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  for (auto _ : state) {
    odometry::Odometry odometry(options, Labels());
    for (const LabeledScan& scan : Scans()) {
      benchmark::DoNotOptimize(odometry.AddScan(scan.points).local_from_sensor);
    }
  }
  ReportPerScan(state);
}
BENCHMARK_CAPTURE(BM_Odometry, kiss_icp, std::string("kiss_icp"))
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Odometry, semantic_kiss, std::string("semantic_kiss"))
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void BM_Subsample(benchmark::State& state) {
  const auto options = semantic_kiss_testing::ShippedOptions().odometry();
  const auto critical = Labels().WithRole(LabelRole::kCritical);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  for (auto _ : state) {
    for (const LabeledScan& scan : Scans()) {
      benchmark::DoNotOptimize(
          odometry::Subsample(scan.points, options.map_subsampling(), critical));
    }
  }
  ReportPerScan(state);
}
BENCHMARK(BM_Subsample)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void BM_Submaps(benchmark::State& state) {
  const auto options = semantic_kiss_testing::ShippedOptions();
  const auto critical = Labels().WithRole(LabelRole::kCritical);
  std::vector<cartographer::sensor::LabeledPointCloud> sparse;
  for (const LabeledScan& scan : Scans()) {
    sparse.push_back(
        odometry::Subsample(scan.points, options.odometry().map_subsampling(), critical));
  }
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  for (auto _ : state) {
    cartographer::submap::ActiveSubmaps submaps(options.submaps(), Labels());
    for (size_t i = 0; i < Scans().size(); ++i) {
      submaps.AddScan(Scans()[i].points, sparse[i],
                      cartographer::transform::Rigid3d::Translation({0.8 * i, 0., 0.}));
    }
  }
  ReportPerScan(state);
}
BENCHMARK(BM_Submaps)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace semantic_kiss

BENCHMARK_MAIN();
