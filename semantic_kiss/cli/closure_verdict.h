// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_CLOSURE_VERDICT_H_
#define SEMANTIC_KISS_CLI_CLOSURE_VERDICT_H_

#include <string>

namespace semantic_kiss::cli {

// What a word of cartographer::pose_graph::VerdictCounts means, for people; empty for other words.
std::string MeaningOf(const std::string& verdict);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_CLOSURE_VERDICT_H_
