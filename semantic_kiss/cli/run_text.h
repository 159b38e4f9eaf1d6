// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_TEXT_H_
#define SEMANTIC_KISS_CLI_RUN_TEXT_H_

#include <optional>
#include <string>

#include "semantic_kiss/cli/run_result.h"

namespace semantic_kiss::cli {

// Figures of a run as text for people, for its summary and its report.

// "1101", "500 of 1101 (stopped)".
std::string ScansText(const RunResult& result);
// "1090 converged, 11 iteration_limit".
std::string OutcomesText(const DriveRecord& drive);
// "id 777: 12 points, ...".
std::string UnknownLabelsText(const dataset::UnknownLabelIds& ids);
// "0.521 %"; "-" if there is no value. Without a unit the number alone.
std::string FigureText(const std::optional<double>& value, int decimals, const char* unit);

double ScansPerSecond(const DriveRecord& drive);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_TEXT_H_
