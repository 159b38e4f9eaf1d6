// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// How long it takes to match a scan with a submap: building the pyramid, searching a window,
// searching the whole submap, for each score, on real scans if there are any.
// scripts/microbenchmark.sh builds and runs it; docs/benchmarks.md has figures.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "cartographer/common/options_loader.h"
#include "cartographer/scan_matching/submap_matcher.h"
#include "glog/logging.h"
#include "semantic_kiss/odometry/odometry.h"
#include "semantic_kiss/odometry/voxel_subsampling.h"
#include "tbb/global_control.h"
#include "test/testing/odometry_on_sequence.h"
#include "test/testing/test_files.h"
#include "test/testing/test_sequence.h"

namespace cartographer::scan_matching {
namespace {

using semantic_kiss_testing::ShippedLabels;
using semantic_kiss_testing::ShippedOptions;

constexpr double kResolution_m = 0.2;
// Half the side of the grid's box: about 546 x 540 cells.
constexpr float kReach_m = 54.f;
// About a thousand points are left of a scan.
constexpr double kVoxelSize_m = 2.2;
constexpr double kMinScore = 0.3;

struct Scene {
  submap::SemanticGrid grid{kResolution_m};
  sensor::LabeledPointCloud scan;  // of the last pose, which is not in the grid
  PlanarPose truth;
};

std::vector<sensor::LabeledScan> Scans() {
  const auto data = semantic_kiss_testing::RealDataDirectory();
  if (data.has_value()) return semantic_kiss_testing::ReadScans(*data + "/semantickitti");
  const semantic_kiss_testing::TemporaryDirectory directory;
  semantic_kiss_testing::WriteTestSequence(directory.path(), {});
  return semantic_kiss_testing::ReadScans(directory.path());
}

sensor::LabeledPointCloud WithinReach(const sensor::LabeledPointCloud& cloud) {
  sensor::LabeledPointCloud result;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.positions[i].head<2>().cwiseAbs().maxCoeff() < kReach_m) result.Append(cloud, i);
  }
  return result;
}

Scene* MakeScene() {
  auto* const scene = new Scene;
  const auto options = ShippedOptions();
  const sensor::LabelSet labels = ShippedLabels();
  semantic_kiss::odometry::Odometry odometry(options.odometry(), labels);
  const std::vector<sensor::LabeledScan> scans = Scans();
  for (size_t i = 0; i < scans.size(); ++i) {
    const transform::Rigid3d pose = odometry.AddScan(scans[i].points).local_from_sensor;
    if (i + 1 < scans.size()) {
      scene->grid.AddCloud(WithinReach(scans[i].points), pose,
                           labels.WithRole(sensor::LabelRole::kMoving));
      continue;
    }
    scene->truth = InPlane(pose);
    auto subsampling = options.odometry().icp_subsampling();
    subsampling.set_voxel_size_m(kVoxelSize_m);
    subsampling.set_max_critical_points_per_voxel(1);
    scene->scan = WithinReach(
        semantic_kiss::odometry::Subsample(scans[i].points, subsampling, sensor::LabelMask()));
  }
  return scene;
}

const Scene& TheScene() {
  static const Scene* const scene = MakeScene();
  return *scene;
}

ScoreModel Model(const std::string& score) {
  proto::ScanMatchingOptions options;
  const absl::Status status = common::LoadOptionsFromString(
      "include \"defaults/scan_matching.lua\"\nSCAN_MATCHING.score.score = \"" + score +
          "\"\nreturn SCAN_MATCHING",
      "benchmark", {semantic_kiss_testing::SourceFile("configuration_files")}, &options);
  CHECK(status.ok()) << status;
  return ScoreModel::Create(options.score(), ShippedLabels()).value();
}

// What the search found, so that a fast failure is not taken for a success.
void Report(const std::optional<Match>& match, benchmark::State& state) {
  state.counters["score"] = match.has_value() ? match->score : 0.;
  if (!match.has_value()) return;
  const PlanarPose& truth = TheScene().truth;
  const double turned_rad =
      std::remainder(match->submap_from_node.yaw_rad - truth.yaw_rad, 2. * M_PI);
  state.counters["error_m"] = (match->submap_from_node.translation - truth.translation).norm();
  state.counters["error_deg"] = std::abs(turned_rad) * 180. / M_PI;
}

void BM_Precompute(benchmark::State& state, const std::string& score) {
  const ScoreModel model = Model(score);
  size_t num_bytes = 0;
  for (auto _ : state) {
    const SubmapMatcher matcher(TheScene().grid, model);
    num_bytes = matcher.num_bytes();
  }
  const auto box = TheScene().grid.Bounds();
  state.counters["cells_x"] = box.max.x() - box.min.x();
  state.counters["cells_y"] = box.max.y() - box.min.y();
  state.counters["MiB"] = num_bytes / 1048576.;
}

// +-10 m, +-30 degrees; the guess is off by 6 m and 20 degrees.
void BM_MatchInWindow(benchmark::State& state, const std::string& score) {
  const ScoreModel model = Model(score);
  const Scene& scene = TheScene();
  const SubmapMatcher matcher(scene.grid, model);
  PlanarPose guess = scene.truth;
  guess.translation += Eigen::Vector2d(5.03, -3.31);
  guess.yaw_rad += 20. * M_PI / 180.;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  std::optional<Match> match;
  for (auto _ : state) {
    const MatchingScan scan(scene.scan, model);
    match = matcher.MatchInWindow(scan, guess, {10., M_PI / 6.}, kMinScore);
    state.counters["points"] = scan.size();
  }
  Report(match, state);
}

void BM_MatchInWholeSubmap(benchmark::State& state, const std::string& score) {
  const ScoreModel model = Model(score);
  const Scene& scene = TheScene();
  const SubmapMatcher matcher(scene.grid, model);
  const MatchingScan scan(scene.scan, model);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  std::optional<Match> match;
  for (auto _ : state) match = matcher.MatchInWholeSubmap(scan, kMinScore);
  Report(match, state);
}

void RegisterAll() {
  for (const std::string score : {"dominant_label", "max_layer", "occupancy"}) {
    benchmark::RegisterBenchmark(("BM_Precompute/" + score).c_str(), BM_Precompute, score)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BM_MatchInWindow/" + score).c_str(), BM_MatchInWindow, score)
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BM_MatchInWholeSubmap/" + score).c_str(), BM_MatchInWholeSubmap,
                                 score)
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace cartographer::scan_matching

int main(int argc, char** argv) {
  cartographer::scan_matching::RegisterAll();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
