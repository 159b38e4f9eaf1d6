// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/metrics.h"

namespace semantic_kiss::evaluation {
namespace {

nlohmann::ordered_json ToJson(const std::optional<double>& figure) {
  return figure ? nlohmann::ordered_json(*figure) : nlohmann::ordered_json(nullptr);
}

}  // namespace

nlohmann::ordered_json ToJson(const Metrics& metrics) {
  return {{"rte_percent", ToJson(metrics.rte_percent)},
          {"rte_deg_per_m", ToJson(metrics.rte_deg_per_m)},
          {"ate_3d_m", ToJson(metrics.ate_3d_m)},
          {"ate_2d_m", ToJson(metrics.ate_2d_m)}};
}

}  // namespace semantic_kiss::evaluation
