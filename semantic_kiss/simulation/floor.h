// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_FLOOR_H_
#define SEMANTIC_KISS_SIMULATION_FLOOR_H_

#include <cstdint>

namespace semantic_kiss::simulation {

// The largest integer that is not above `value`, |value| < 2^62. std::floor is a call of a library
// on processors without SSE 4.1, for which Debian compiles.
inline int64_t Floor(double value) {
  const auto truncated = static_cast<int64_t>(value);
  return truncated - (value < static_cast<double>(truncated) ? 1 : 0);
}

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_FLOOR_H_
