// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_REPORT_CHARTS_H_
#define SEMANTIC_KISS_CLI_RUN_REPORT_CHARTS_H_

#include <vector>

#include "semantic_kiss/cli/run_result.h"
#include "semantic_kiss/report/report.h"

namespace semantic_kiss::cli {

// The charts of a run's report: heights, errors along the way and by length of segments (both with
// ground truth only), what loop closures moved, time of the stages. Where nothing was closed, the
// odometry is the result and has no line of its own.
std::vector<report::Chart> RunCharts(const RunResult& result);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_REPORT_CHARTS_H_
