// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_VERSION_H_
#define SEMANTIC_KISS_CLI_VERSION_H_

namespace semantic_kiss::cli {

// The project's version, "1.2.3", as CMakeLists.txt states it.
const char* Version();

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_VERSION_H_
