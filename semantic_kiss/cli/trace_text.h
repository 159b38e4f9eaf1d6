// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_TRACE_TEXT_H_
#define SEMANTIC_KISS_CLI_TRACE_TEXT_H_

#include <string>

#include "cartographer/sensor/label_set.h"
#include "nlohmann/json.hpp"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/cli/traced_scan.h"

namespace semantic_kiss::cli {

// A table: a line for each step, and one for the commonest labels where the step tells them. What
// is long is wrapped at the terminal's width, or at 120 columns.
std::string TraceText(const TracedScan& traced, const cartographer::sensor::LabelSet& labels,
                      const Terminal& terminal);

// {"scan", "node": whether it is one, "steps": [{"stage", "frame", "outcome", "from", "points_in",
// "points_out", "labels": {name: points}, "ms"}]}; what a step does not tell is null, of labels {}.
nlohmann::ordered_json TraceJson(const TracedScan& traced,
                                 const cartographer::sensor::LabelSet& labels);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_TRACE_TEXT_H_
