// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_BLOCK_SUMS_H_
#define CARTOGRAPHER_SCAN_MATCHING_BLOCK_SUMS_H_

#include <cstddef>
#include <cstdint>

namespace cartographer::scan_matching {

// A byte to look up, and what it weighs.
struct Lookup {
  int32_t offset;
  int32_t weight;  // in [0, 32767]
};

// The inner loop of the search: weighted sums over the look-ups for a square block of shifts at
// once,
//
//   sums[y * side + x] = sum over look-ups l of l.weight * bytes[l.offset + y * stride + x],
//
// 0 <= x, y < side. `side` is 4 or 8 (CHECKed); `sums` has room for side * side. All these bytes
// must exist and the sums must fit. Room for one look-up after the last is written to.
void SumBlock(const uint8_t* bytes, int stride, int side, Lookup* lookups, size_t num_lookups,
              int32_t* sums);

// The same, plainly written: for machines without SSE2, and to test the other by.
void SumBlockPortably(const uint8_t* bytes, int stride, int side, const Lookup* lookups,
                      size_t num_lookups, int32_t* sums);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_BLOCK_SUMS_H_
