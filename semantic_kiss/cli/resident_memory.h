// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RESIDENT_MEMORY_H_
#define SEMANTIC_KISS_CLI_RESIDENT_MEMORY_H_

namespace semantic_kiss::cli {

// Memory that the process holds at the moment, in MiB; 0 where the system does not tell.
double ResidentMemory_mib();

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RESIDENT_MEMORY_H_
