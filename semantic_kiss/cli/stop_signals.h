// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_STOP_SIGNALS_H_
#define SEMANTIC_KISS_CLI_STOP_SIGNALS_H_

namespace semantic_kiss::cli {

// SIGINT (Ctrl-C) and SIGTERM end the program at once, with exit code 128 + the signal's number
// and without leaving temporary files. A command that can stop in good order, with what is
// finished so far written whole, says so by StopInGoodOrder(): then the first signal only sets
// StopRequested(), and the second ends the program.

// Begins to watch. Call once, in main(), before any other thread starts: these inherit that the
// signals are not theirs.
void WatchStopSignals();

void StopInGoodOrder();

bool StopRequested();

// 128 + the signal that asked to stop, as shells have it: 130 for SIGINT, 143 for SIGTERM.
// Only after StopRequested().
int StopExitCode();

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_STOP_SIGNALS_H_
