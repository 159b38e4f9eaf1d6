// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_REPORT_MAP_H_
#define SEMANTIC_KISS_CLI_RUN_REPORT_MAP_H_

#include "semantic_kiss/cli/run_result.h"
#include "semantic_kiss/report/report.h"

namespace semantic_kiss::cli {

// The map of a run with the drive in it, scan by scan: trajectory, odometry, ground truth
// (aligned), loop closures, and the quantities by which the trajectory is coloured, the error
// first.
report::MapView RunMapView(const RunResult& result, report::MapLayers layers);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_REPORT_MAP_H_
