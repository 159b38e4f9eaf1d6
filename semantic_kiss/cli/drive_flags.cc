// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/drive_flags.h"

#include <unistd.h>

#include <iostream>
#include <utility>

#include "cartographer/common/status.h"
#include "cartographer/slam/local_trajectory_builder_registry.h"
#include "cartographer/slam/planar_local_trajectory_builder.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/dataset/prefetching_scan_source.h"
#include "semantic_kiss/dataset/semantic_kitti_source.h"
#include "semantic_kiss/local_trajectory_builder.h"

namespace semantic_kiss::cli {
namespace {

dataset::ScanRange SelectedScans() {
  dataset::ScanRange range;
  if (IsGiven("first_scan")) range.first = FLAGS_first_scan;
  if (FLAGS_num_scans > 0) range.count = FLAGS_num_scans;
  return range;
}

}  // namespace

absl::StatusOr<std::unique_ptr<dataset::ScanSource>> OpenScans(const Configuration& configuration) {
  ASSIGN_OR_RETURN(std::unique_ptr<dataset::ScanSource> scans,
                   dataset::OpenSemanticKitti(
                       {FLAGS_dataset, FLAGS_sequence, FLAGS_labels_dir, FLAGS_ground_truth},
                       SelectedScans(), configuration.options.dataset(), configuration.labels));
  return std::make_unique<dataset::PrefetchingScanSource>(std::move(scans));
}

absl::StatusOr<std::unique_ptr<cartographer::slam::LocalTrajectoryBuilder>>
MakeLocalTrajectoryBuilder(const Configuration& configuration) {
  cartographer::slam::LocalTrajectoryBuilderRegistry registry;
  RegisterLocalTrajectoryBuilder(&registry);
  cartographer::slam::RegisterPlanarLocalTrajectoryBuilder(&registry);
  return registry.Create(configuration.options.local_trajectory_builder(), configuration.labels);
}

ProgressReporter MakeProgressReporter(int num_scans) {
  const Terminal terminal = Terminal::Of(STDERR_FILENO);
  auto mode = terminal.interactive ? ProgressReporter::Mode::kBar : ProgressReporter::Mode::kLines;
  if (FLAGS_quiet) mode = ProgressReporter::Mode::kSilent;
  return ProgressReporter(mode, terminal, num_scans, &SteadySeconds, &std::cerr);
}

}  // namespace semantic_kiss::cli
