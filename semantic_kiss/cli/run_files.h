// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_FILES_H_
#define SEMANTIC_KISS_CLI_RUN_FILES_H_

#include "absl/status/status.h"
#include "semantic_kiss/cli/output_directory.h"
#include "semantic_kiss/cli/proto/run_options.pb.h"
#include "semantic_kiss/cli/run_result.h"

namespace semantic_kiss::cli {

// Writes all files of a run, all of them or none: odometry_kitti.txt, trajectory_kitti.txt (poses
// of the camera if the data set has one), trajectory_tum.txt (poses of the lidar), map.pbstream,
// map.png, run.json and report.html. Of these the last two alone tell times; all others are the
// same bytes whenever, and on however many threads, the run is repeated. How long writing took is
// added to `result`.
absl::Status WriteRunFiles(const OutputDirectory& directory, const proto::RunOptions& options,
                           RunResult* result);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_FILES_H_
