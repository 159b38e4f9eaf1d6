// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/block_sums.h"

#include <algorithm>

#include "glog/logging.h"

#if defined(__SSE2__)
#include <emmintrin.h>

#include <cstring>
#endif

namespace cartographer::scan_matching {

void SumBlockPortably(const uint8_t* bytes, int stride, int side, const Lookup* lookups,
                      size_t num_lookups, int32_t* sums) {
  std::fill(sums, sums + side * side, 0);
  for (size_t i = 0; i < num_lookups; ++i) {
    const Lookup& lookup = lookups[i];
    for (int y = 0; y < side; ++y) {
      const uint8_t* const row = bytes + lookup.offset + y * stride;
      for (int x = 0; x < side; ++x) sums[y * side + x] += lookup.weight * row[x];
    }
  }
}

#if defined(__SSE2__)
namespace {

// Two look-ups are summed in one step: their bytes are interleaved and widened to 16 bits, so that
// one instruction multiplies both by their weights and adds the products in 32 bits.
__m128i WeightsOf(const Lookup* pair) {
  return _mm_set1_epi32(pair[0].weight | pair[1].weight << 16);
}

// Four rows of eight shifts, beginning at row `first_row` of the block.
void SumFourRowsOf8(const uint8_t* bytes, int stride, const Lookup* lookups, size_t num_lookups,
                    int first_row, int32_t* sums) {
  const __m128i zero = _mm_setzero_si128();
  __m128i low[4] = {zero, zero, zero, zero}, high[4] = {zero, zero, zero, zero};
  for (size_t i = 0; i < num_lookups; i += 2) {
    const __m128i weights = WeightsOf(&lookups[i]);
    const uint8_t* const a = bytes + lookups[i].offset + first_row * stride;
    const uint8_t* const b = bytes + lookups[i + 1].offset + first_row * stride;
    for (int y = 0; y < 4; ++y) {
      const __m128i both =
          _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(a + y * stride)),
                            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(b + y * stride)));
      low[y] = _mm_add_epi32(low[y], _mm_madd_epi16(_mm_unpacklo_epi8(both, zero), weights));
      high[y] = _mm_add_epi32(high[y], _mm_madd_epi16(_mm_unpackhi_epi8(both, zero), weights));
    }
  }
  for (int y = 0; y < 4; ++y) {
    __m128i* const row = reinterpret_cast<__m128i*>(sums + (first_row + y) * 8);
    _mm_storeu_si128(row, low[y]);
    _mm_storeu_si128(row + 1, high[y]);
  }
}

__m128i LoadFour(const uint8_t* bytes) {
  int32_t word;
  std::memcpy(&word, bytes, sizeof(word));
  return _mm_cvtsi32_si128(word);
}

void SumFourRowsOf4(const uint8_t* bytes, int stride, const Lookup* lookups, size_t num_lookups,
                    int32_t* sums) {
  const __m128i zero = _mm_setzero_si128();
  __m128i rows[4] = {zero, zero, zero, zero};
  for (size_t i = 0; i < num_lookups; i += 2) {
    const __m128i weights = WeightsOf(&lookups[i]);
    const uint8_t* const a = bytes + lookups[i].offset;
    const uint8_t* const b = bytes + lookups[i + 1].offset;
    for (int y = 0; y < 4; ++y) {
      const __m128i both = _mm_unpacklo_epi8(LoadFour(a + y * stride), LoadFour(b + y * stride));
      rows[y] = _mm_add_epi32(rows[y], _mm_madd_epi16(_mm_unpacklo_epi8(both, zero), weights));
    }
  }
  for (int y = 0; y < 4; ++y) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(sums + y * 4), rows[y]);
  }
}

}  // namespace

void SumBlock(const uint8_t* bytes, int stride, int side, Lookup* lookups, size_t num_lookups,
              int32_t* sums) {
  CHECK(side == 4 || side == 8);
  if (num_lookups % 2 == 1) lookups[num_lookups] = {lookups[num_lookups - 1].offset, 0};
  if (side == 4) return SumFourRowsOf4(bytes, stride, lookups, num_lookups, sums);
  SumFourRowsOf8(bytes, stride, lookups, num_lookups, 0, sums);
  SumFourRowsOf8(bytes, stride, lookups, num_lookups, 4, sums);
}

#else

void SumBlock(const uint8_t* bytes, int stride, int side, Lookup* lookups, size_t num_lookups,
              int32_t* sums) {
  CHECK(side == 4 || side == 8);
  SumBlockPortably(bytes, stride, side, lookups, num_lookups, sums);
}

#endif

}  // namespace cartographer::scan_matching
