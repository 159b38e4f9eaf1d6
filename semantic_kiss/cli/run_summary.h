// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_SUMMARY_H_
#define SEMANTIC_KISS_CLI_RUN_SUMMARY_H_

#include <string>

#include "semantic_kiss/cli/run_result.h"
#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::cli {

// What a run's last lines on the terminal tell, `directory` being where its files are.
std::string RunSummary(const RunResult& result, const std::string& directory,
                       const Terminal& terminal);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_SUMMARY_H_
