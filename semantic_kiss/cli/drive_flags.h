// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_DRIVE_FLAGS_H_
#define SEMANTIC_KISS_CLI_DRIVE_FLAGS_H_

#include <memory>

#include "absl/status/statusor.h"
#include "cartographer/slam/local_trajectory_builder.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/progress.h"
#include "semantic_kiss/dataset/scan_source.h"

namespace semantic_kiss::cli {

// What commands that go through the scans of a drive make of their flags and configuration.

// The scans of --dataset, --sequence, --labels_dir, --ground_truth, --first_scan, --num_scans.
absl::StatusOr<std::unique_ptr<dataset::ScanSource>> OpenScans(const Configuration& configuration);

absl::StatusOr<std::unique_ptr<cartographer::slam::LocalTrajectoryBuilder>>
MakeLocalTrajectoryBuilder(const Configuration& configuration);

// On standard error: a bar for a terminal, lines for a log, nothing with --quiet.
ProgressReporter MakeProgressReporter(int num_scans);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_DRIVE_FLAGS_H_
