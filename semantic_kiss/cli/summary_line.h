// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_SUMMARY_LINE_H_
#define SEMANTIC_KISS_CLI_SUMMARY_LINE_H_

#include <string>

#include "absl/strings/string_view.h"
#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::cli {

// A line of what a command tells at its end: a styled heading, and a text that is wrapped beside
// it, for people alone; scripts look for whole lines.
std::string SummaryLine(const Terminal& terminal, Style style, absl::string_view heading,
                        const std::string& text);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_SUMMARY_LINE_H_
