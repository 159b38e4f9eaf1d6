// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_PROGRAM_H_
#define SEMANTIC_KISS_CLI_PROGRAM_H_

#include <string>
#include <vector>

namespace semantic_kiss::cli {

// Exit codes beside these: 130 and 143 (stop_signals.h).
inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;  // bad input or a failed run; one line on stderr says why
inline constexpr int kExitUsage = 2;   // the command line is wrong

// The whole program but for process-wide set-up (logging, signals): reads the command line, without
// the program's name, runs the command with the threads that it asks for, and returns the exit
// code.
int RunProgram(const std::vector<std::string>& arguments);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_PROGRAM_H_
