// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_METRICS_H_
#define SEMANTIC_KISS_EVALUATION_METRICS_H_

#include <nlohmann/json.hpp>
#include <optional>

namespace semantic_kiss::evaluation {

// The figures that tables show. Absent: the figure does not exist (no ground truth, under 100 m
// driven, fewer than three poses).
struct Metrics {
  std::optional<double> rte_percent;    // relative_error.h
  std::optional<double> rte_deg_per_m;  // relative_error.h
  std::optional<double> ate_3d_m;       // absolute_error.h
  std::optional<double> ate_2d_m;       // absolute_error.h
};

// {"rte_percent": ..., "rte_deg_per_m": ..., "ate_3d_m": ..., "ate_2d_m": ...}, always all four
// keys in this order, null for what is absent; numbers with all their digits.
nlohmann::ordered_json ToJson(const Metrics& metrics);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_METRICS_H_
