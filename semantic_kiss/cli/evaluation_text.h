// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_EVALUATION_TEXT_H_
#define SEMANTIC_KISS_CLI_EVALUATION_TEXT_H_

#include <string>

#include "semantic_kiss/evaluation/evaluation.h"

namespace semantic_kiss::cli {

// An evaluation for people, a figure a line; "-" for what does not exist.
std::string EvaluationText(const evaluation::Evaluation& evaluation, int num_poses);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_EVALUATION_TEXT_H_
