// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_IO_MEMORY_PEAK_H_
#define TEST_CARTOGRAPHER_IO_MEMORY_PEAK_H_

#include <cstddef>

namespace cartographer::io {

// Counts what this program takes through operator new (memory_peak.cc replaces it), by all
// threads.
class MemoryPeak {
 public:
  // Starts a new measurement.
  MemoryPeak();
  // The most bytes that were held at once since then, beyond what was held at its start.
  size_t bytes() const;

 private:
  size_t at_start_;
};

}  // namespace cartographer::io

#endif  // TEST_CARTOGRAPHER_IO_MEMORY_PEAK_H_
