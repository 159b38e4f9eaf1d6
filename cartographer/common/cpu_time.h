// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_CPU_TIME_H_
#define CARTOGRAPHER_COMMON_CPU_TIME_H_

#include <ctime>

namespace cartographer::common {

// Processor time that the calling thread has used [s], whoever else keeps the machine busy.
inline double ThreadCpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_CPU_TIME_H_
