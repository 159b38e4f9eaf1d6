// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// What a loop closure candidate costs: the match in a window, its refinement in the plane, the
// target (once a submap), the verification; on real scans if there are any. One thread.
// scripts/microbenchmark.sh builds and runs it; docs/loop_closure.md has figures.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cartographer/common/options_loader.h"
#include "cartographer/pose_graph/verify_closure.h"
#include "cartographer/scan_matching/refine_in_plane.h"
#include "cartographer/slam/local_trajectory_builder.h"
#include "glog/logging.h"
#include "semantic_kiss/local_trajectory_builder.h"
#include "tbb/global_control.h"
#include "test/testing/odometry_on_sequence.h"
#include "test/testing/test_files.h"
#include "test/testing/test_sequence.h"

namespace cartographer::pose_graph {
namespace {

using scan_matching::MatchingScan;
using scan_matching::PlanarPose;
using scan_matching::SubmapMatcher;
using transform::Rigid3d;

template <typename Options>
Options LoadDefaults(const std::string& file, const std::string& table) {
  Options options;
  const absl::Status status = common::LoadOptionsFromString(
      "include \"defaults/" + file + "\"\nreturn " + table, "benchmark",
      {semantic_kiss_testing::SourceFile("configuration_files")}, &options);
  CHECK(status.ok()) << status;
  return options;
}

std::vector<sensor::LabeledScan> Scans() {
  const auto data = semantic_kiss_testing::RealDataDirectory();
  if (data.has_value()) return semantic_kiss_testing::ReadScans(*data + "/semantickitti");
  const semantic_kiss_testing::TemporaryDirectory directory;
  semantic_kiss_testing::TestStreet street;
  street.num_scans = 16;
  semantic_kiss_testing::WriteTestSequence(directory.path(), street);
  return semantic_kiss_testing::ReadScans(directory.path());
}

// The last node, and the first submap that it might close a loop with.
struct Drive {
  Drive() {
    auto options = semantic_kiss_testing::ShippedOptions();
    // Finished before the last node, so that this comes from outside.
    options.mutable_submaps()->set_scans_per_submap(12);
    semantic_kiss::LocalTrajectoryBuilder builder(options, labels);
    for (const sensor::LabeledScan& scan : Scans()) {
      const slam::LocalResult result = builder.AddScan(scan);
      if (!result.insertion.has_value()) continue;
      local_from_node = result.local_from_sensor;
      cloud = result.insertion->cloud;
      if (submap == nullptr) submap = result.insertion->submaps.begin()->second;
    }
    CHECK(submap->finished);
  }

  const sensor::LabelSet labels = semantic_kiss_testing::ShippedLabels();
  std::shared_ptr<const submap::Submap> submap;
  Rigid3d local_from_node;
  std::shared_ptr<const sensor::LabeledPointCloud> cloud;
};

struct Scene {
  Scene()
      : model(scan_matching::ScoreModel::Create(matching.score(), drive.labels).value()),
        matcher(drive.submap->grid, model),
        truth(drive.submap->local_from_submap.inverse() * drive.local_from_node),
        tilt(transform::Level(drive.local_from_node).inverse() * drive.local_from_node),
        level_cloud(*drive.cloud) {
    for (Eigen::Vector3f& position : level_cloud.positions) {
      position = (tilt * position.cast<double>().eval()).cast<float>();
    }
  }

  ClosureTarget MakeTarget() const {
    return ClosureTarget({{&drive.submap->cloud, Rigid3d::Identity()}}, drive.labels, verification);
  }
  // As far off as a match is.
  PlanarPose NearTruth() const {
    PlanarPose pose = scan_matching::InPlane(truth);
    pose.translation += Eigen::Vector2d(0.08, -0.06);
    pose.yaw_rad += 0.1 * M_PI / 180.;
    return pose;
  }

  const scan_matching::proto::ScanMatchingOptions matching =
      LoadDefaults<scan_matching::proto::ScanMatchingOptions>("scan_matching.lua", "SCAN_MATCHING");
  const proto::VerificationOptions verification =
      LoadDefaults<proto::VerificationOptions>("closure_verification.lua", "CLOSURE_VERIFICATION");
  const Drive drive;
  const scan_matching::ScoreModel model;
  const SubmapMatcher matcher;
  const Rigid3d truth;  // submap_from_node by the odometry, a few metres farther on
  const Rigid3d tilt;
  sensor::LabeledPointCloud level_cloud;
};

const Scene& TheScene() {
  static const Scene* const scene = new Scene;
  return *scene;
}

void ReportError(const Rigid3d& pose, benchmark::State& state) {
  const Rigid3d error = TheScene().truth.inverse() * pose;
  state.counters["error_m"] = error.translation().norm();
  state.counters["error_deg"] = transform::RotationAngle(error) * 180. / M_PI;
  state.counters["points"] = static_cast<double>(TheScene().drive.cloud->size());
}

void BM_ClosureMatch(benchmark::State& state) {
  const Scene& scene = TheScene();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  PlanarPose guess = scan_matching::InPlane(scene.truth);
  guess.translation += Eigen::Vector2d(1.03, -2.31);
  guess.yaw_rad += 0.05;
  PlanarPose found;
  for (auto _ : state) {
    const MatchingScan scan(scene.level_cloud, scene.model);
    const auto match = scene.matcher.MatchInWindow(scan, guess, {4., 0.1}, 0.25);
    CHECK(match.has_value());
    found = match->submap_from_node;
  }
  ReportError(Rigid3d::Translation({0., 0., scene.truth.translation().z()}) *
                  scan_matching::InSpace(found) * scene.tilt,
              state);
}
BENCHMARK(BM_ClosureMatch)->Unit(benchmark::kMillisecond);

void BM_ClosureRefineInPlane(benchmark::State& state) {
  const Scene& scene = TheScene();
  const MatchingScan scan(scene.level_cloud, scene.model);
  scan_matching::PlanarRefinement refined;
  for (auto _ : state) {
    refined = RefineInPlane(scene.matcher, scan, scene.NearTruth(), scene.matching.refinement());
  }
  ReportError(Rigid3d::Translation({0., 0., scene.truth.translation().z()}) *
                  scan_matching::InSpace(refined.submap_from_node) * scene.tilt,
              state);
}
BENCHMARK(BM_ClosureRefineInPlane)->Unit(benchmark::kMillisecond);

void BM_ClosureMakeTarget(benchmark::State& state) {
  const Scene& scene = TheScene();
  for (auto _ : state) benchmark::DoNotOptimize(scene.MakeTarget());
  state.counters["points"] = static_cast<double>(scene.drive.submap->cloud.size());
}
BENCHMARK(BM_ClosureMakeTarget)->Unit(benchmark::kMillisecond);

void BM_ClosureVerify(benchmark::State& state) {
  const Scene& scene = TheScene();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const ClosureTarget target = scene.MakeTarget();
  ClosureReport report;
  for (auto _ : state) {
    report =
        VerifyClosure(*scene.drive.cloud, scan_matching::InSpace(scene.NearTruth()) * scene.tilt,
                      target, scene.verification);
  }
  CHECK(report.accepted()) << VerdictName(report.verdict);
  ReportError(report.submap_from_node, state);
}
BENCHMARK(BM_ClosureVerify)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cartographer::pose_graph

BENCHMARK_MAIN();
