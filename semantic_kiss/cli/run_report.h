// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_REPORT_H_
#define SEMANTIC_KISS_CLI_RUN_REPORT_H_

#include <string>

#include "semantic_kiss/cli/run_result.h"
#include "semantic_kiss/report/map_layers.h"
#include "semantic_kiss/report/report.h"

namespace semantic_kiss::cli {

// What report.html says of a run. `layers` is the run's map, taken apart.
report::Report RunReport(const RunResult& result, report::MapLayers layers);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_REPORT_H_
