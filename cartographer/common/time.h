// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_TIME_H_
#define CARTOGRAPHER_COMMON_TIME_H_

#include <chrono>
#include <cstdint>
#include <ratio>

namespace cartographer::common {

// Time as pbstream files count it: ticks of 100 ns since 0001-01-01T00:00:00Z ("universal time").
using Duration = std::chrono::duration<int64_t, std::ratio<1, 10'000'000>>;

struct UniversalClock {
  using rep = Duration::rep;
  using period = Duration::period;
  using duration = Duration;
  using time_point = std::chrono::time_point<UniversalClock>;
  static constexpr bool is_steady = true;
};
using Time = UniversalClock::time_point;

// 1970-01-01T00:00:00Z on the universal time scale.
inline constexpr Time kUnixEpoch{Duration{621'355'968'000'000'000}};

// Rounds to the nearest tick.
Duration FromSeconds(double seconds);
double ToSeconds(Duration duration);

// Seconds since the Unix epoch, to and from.
Time FromUnixSeconds(double seconds);
double ToUnixSeconds(Time time);

inline constexpr Time FromUniversal(int64_t ticks) { return Time{Duration{ticks}}; }
inline constexpr int64_t ToUniversal(Time time) { return time.time_since_epoch().count(); }

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_TIME_H_
