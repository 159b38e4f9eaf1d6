// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/metrics.h"

#include <gtest/gtest.h>

namespace semantic_kiss::evaluation {
namespace {

TEST(MetricsTest, AbsentFiguresAreNull) {
  EXPECT_EQ(ToJson(Metrics()).dump(),
            R"({"rte_percent":null,"rte_deg_per_m":null,"ate_3d_m":null,"ate_2d_m":null})");
}

TEST(MetricsTest, FiguresKeepTheirDigits) {
  Metrics metrics;
  metrics.rte_percent = 0.48;
  metrics.rte_deg_per_m = 0.1 + 0.2;
  metrics.ate_3d_m = 0.;
  EXPECT_EQ(
      ToJson(metrics).dump(),
      R"({"rte_percent":0.48,"rte_deg_per_m":0.30000000000000004,"ate_3d_m":0.0,"ate_2d_m":null})");
}

}  // namespace
}  // namespace semantic_kiss::evaluation
