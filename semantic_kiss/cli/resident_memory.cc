// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/resident_memory.h"

#include <unistd.h>

#include <cstdint>
#include <fstream>

namespace semantic_kiss::cli {

double ResidentMemory_mib() {
  std::ifstream pages("/proc/self/statm");
  int64_t whole = 0, resident = 0;
  if (!(pages >> whole >> resident)) return 0.;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.;
}

}  // namespace semantic_kiss::cli
