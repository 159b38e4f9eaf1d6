// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/version.h"

namespace semantic_kiss::cli {

const char* Version() { return SEMANTIC_KISS_VERSION; }

}  // namespace semantic_kiss::cli
