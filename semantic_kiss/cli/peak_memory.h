// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_PEAK_MEMORY_H_
#define SEMANTIC_KISS_CLI_PEAK_MEMORY_H_

namespace semantic_kiss::cli {

// The most physical memory that this process has held so far.
double PeakMemory_mib();

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_PEAK_MEMORY_H_
