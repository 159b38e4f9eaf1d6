// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_REPORT_H_
#define SEMANTIC_KISS_CLI_RUN_REPORT_H_

#include <string>

#include "absl/strings/string_view.h"
#include "semantic_kiss/cli/run_result.h"
#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::cli {

// The content of report.html. `map_image` is a PNG file's.
std::string RunReport(const RunResult& result, absl::string_view map_image);

// What a run's last lines on the terminal tell, `directory` being where its files are.
std::string RunSummary(const RunResult& result, const std::string& directory,
                       const Terminal& terminal);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_REPORT_H_
