// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_STOPWATCH_H_
#define CARTOGRAPHER_COMMON_STOPWATCH_H_

#include <chrono>
#include <string>
#include <vector>

namespace cartographer::common {

// How long one stage of the work took.
struct StageTime {
  std::string stage;
  double seconds = 0.;
};

// Splits the way through a function into stages. Times are for people to read; nothing may be
// decided by them.
class Stopwatch {
 public:
  Stopwatch() : last_(std::chrono::steady_clock::now()) {}

  // Seconds since construction or the last Lap().
  double Lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

  // Books the time since the last lap on a stage.
  void Lap(const std::string& stage, std::vector<StageTime>* times) {
    times->push_back({stage, Lap()});
  }

 private:
  std::chrono::steady_clock::time_point last_;
};

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_STOPWATCH_H_
