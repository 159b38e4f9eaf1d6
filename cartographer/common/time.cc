// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/time.h"

#include <cmath>

namespace cartographer::common {
namespace {
constexpr double kTicksPerSecond = 1e7;
}  // namespace

Duration FromSeconds(double seconds) { return Duration{std::llround(seconds * kTicksPerSecond)}; }

double ToSeconds(Duration duration) {
  return static_cast<double>(duration.count()) / kTicksPerSecond;
}

Time FromUnixSeconds(double seconds) { return kUnixEpoch + FromSeconds(seconds); }

double ToUnixSeconds(Time time) { return ToSeconds(time - kUnixEpoch); }

}  // namespace cartographer::common
