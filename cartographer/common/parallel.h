// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_PARALLEL_H_
#define CARTOGRAPHER_COMMON_PARALLEL_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cartographer/common/fork_join_annotation.h"
#include "tbb/parallel_for.h"

namespace cartographer::common {

// Parallel loops whose results do not depend on the number of threads: the range [0, size) is cut
// into chunks of `chunk_size` (the last may be shorter) whatever the machine, and what chunks
// return is combined in their order. Threads come from the calling tbb::task_arena; the
// application's main() decides how many there are.

// Calls body(begin, end) for every chunk, in parallel. Chunks must not touch shared state.
template <typename Body>
void ParallelChunks(size_t size, size_t chunk_size, const Body& body) {
  const size_t num_chunks = (size + chunk_size - 1) / chunk_size;
  ForkJoinAnnotation order;
  tbb::parallel_for(size_t{0}, num_chunks, [&](size_t chunk) {
    order.TaskBegins();
    body(chunk * chunk_size, std::min(size, (chunk + 1) * chunk_size));
    order.TaskEnds();
  });
  order.AllTasksEnded();
}

// Returns map(begin, end) of all chunks, in the order of the chunks. Result must be
// default-constructible.
template <typename Result, typename Map>
std::vector<Result> ParallelMapChunks(size_t size, size_t chunk_size, const Map& map) {
  std::vector<Result> results((size + chunk_size - 1) / chunk_size);
  ParallelChunks(size, chunk_size,
                 [&](size_t begin, size_t end) { results[begin / chunk_size] = map(begin, end); });
  return results;
}

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_PARALLEL_H_
