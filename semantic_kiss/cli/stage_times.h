// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_STAGE_TIMES_H_
#define SEMANTIC_KISS_CLI_STAGE_TIMES_H_

#include <string>
#include <utility>
#include <vector>

#include "nlohmann/json.hpp"

namespace semantic_kiss::cli {

// What a stage took over a run.
struct StageSummary {
  double median_ms = 0.;
  double p95_ms = 0.;  // 95 of 100 calls took at most this long
  double total_s = 0.;
};

// The summary of single durations [ms], of which there must be one at least (CHECKed). The median
// of an even number is the mean of the middle two; percentiles are by nearest rank.
StageSummary Summarize(std::vector<double> durations_ms);

// Durations of a run's stages, by name, in the order in which the stages first appeared.
class StageTimes {
 public:
  void Add(const std::string& stage, double seconds);

  std::vector<std::pair<std::string, StageSummary>> Summaries() const;

  // Durations of a stage, in the order of their calls; never empty.
  const std::vector<std::pair<std::string, std::vector<double>>>& durations_ms() const {
    return durations_ms_;
  }

 private:
  std::vector<std::pair<std::string, std::vector<double>>> durations_ms_;
};

// {stage: {median_ms, p95_ms, total_s}}.
nlohmann::ordered_json ToJson(const StageTimes& times);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_STAGE_TIMES_H_
