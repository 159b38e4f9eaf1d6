// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdio>
#include <string>
#include <vector>

#include "cartographer/common/parallel.h"
#include "tbb/global_control.h"
#include "tbb/task_arena.h"

// A parallel loop as it should be, or with the argument "race" one whose chunks share a counter:
// shows that the thread sanitizer, with our suppressions, accepts the one and reports the other.
int main(int argc, char** argv) {
  const bool race = argc > 1 && std::string(argv[1]) == "race";
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena arena(8);
  int shared = 0;
  for (int repetition = 0; repetition < 100; ++repetition) {
    arena.execute([&] {
      const std::vector<std::string> texts =
          cartographer::common::ParallelMapChunks<std::string>(1000, 10, [&](size_t begin, size_t) {
            if (race) ++shared;
            return std::string(100, static_cast<char>('a' + begin % 26));
          });
      for (const std::string& text : texts) shared += text.size() == 100 ? 1 : 0;
    });
  }
  std::printf("%d\n", shared);
}
