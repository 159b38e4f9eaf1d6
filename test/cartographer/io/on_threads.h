// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_IO_ON_THREADS_H_
#define TEST_CARTOGRAPHER_IO_ON_THREADS_H_

#include "tbb/global_control.h"
#include "tbb/task_arena.h"

namespace cartographer::io {

// What body() returns when its parallel loops have that many threads, however many cores there are.
template <typename Body>
auto OnThreads(int threads, const Body& body) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  return arena.execute(body);
}

}  // namespace cartographer::io

#endif  // TEST_CARTOGRAPHER_IO_ON_THREADS_H_
