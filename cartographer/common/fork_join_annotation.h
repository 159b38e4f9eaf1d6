// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_FORK_JOIN_ANNOTATION_H_
#define CARTOGRAPHER_COMMON_FORK_JOIN_ANNOTATION_H_

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace cartographer::common {

// Tells the thread sanitizer how a parallel loop is ordered: its beginning before every task, every
// task before its end, tasks among each other not at all. The sanitizer cannot see that by itself,
// for the TBB library that orders them is not instrumented; so it would report the data that a
// loop is given and those that it returns. Races between tasks are still found. Without the
// sanitizer all of this is nothing.
class ForkJoinAnnotation {
 public:
  ForkJoinAnnotation() { Release(&fork_); }

  void TaskBegins() { Acquire(&fork_); }
  void TaskEnds() { Release(&join_); }
  void AllTasksEnded() { Acquire(&join_); }

 private:
#if defined(__SANITIZE_THREAD__)
  static void Acquire(char* event) { __tsan_acquire(event); }
  static void Release(char* event) { __tsan_release(event); }
#else
  static void Acquire(char*) {}
  static void Release(char*) {}
#endif

  char fork_ = 0;
  char join_ = 0;
};

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_FORK_JOIN_ANNOTATION_H_
