// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/peak_memory.h"

#include <sys/resource.h>

#include "glog/logging.h"

namespace semantic_kiss::cli {

double PeakMemory_mib() {
  rusage usage{};
  CHECK_EQ(getrusage(RUSAGE_SELF, &usage), 0);
  return static_cast<double>(usage.ru_maxrss) / 1024.;  // Linux counts KiB
}

}  // namespace semantic_kiss::cli
