// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/stage_times.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "glog/logging.h"

namespace semantic_kiss::cli {

StageSummary Summarize(std::vector<double> durations_ms) {
  CHECK(!durations_ms.empty());
  std::sort(durations_ms.begin(), durations_ms.end());
  const size_t size = durations_ms.size();
  StageSummary summary;
  summary.median_ms = (durations_ms[(size - 1) / 2] + durations_ms[size / 2]) / 2.;
  summary.p95_ms = durations_ms[(95 * size + 99) / 100 - 1];
  summary.total_s = std::accumulate(durations_ms.begin(), durations_ms.end(), 0.) / 1e3;
  return summary;
}

void StageTimes::Add(const std::string& stage, double seconds) {
  const double duration_ms = 1e3 * seconds;
  for (auto& [name, durations_ms] : durations_ms_) {
    if (name != stage) continue;
    durations_ms.push_back(duration_ms);
    return;
  }
  durations_ms_.push_back({stage, {duration_ms}});
}

std::vector<std::pair<std::string, StageSummary>> StageTimes::Summaries() const {
  std::vector<std::pair<std::string, StageSummary>> summaries;
  for (const auto& [name, durations_ms] : durations_ms_) {
    summaries.emplace_back(name, Summarize(durations_ms));
  }
  return summaries;
}

nlohmann::ordered_json ToJson(const StageTimes& times) {
  auto stages = nlohmann::ordered_json::object();
  for (const auto& [stage, summary] : times.Summaries()) {
    stages[stage] = {
        {"median_ms", summary.median_ms}, {"p95_ms", summary.p95_ms}, {"total_s", summary.total_s}};
  }
  return stages;
}

}  // namespace semantic_kiss::cli
