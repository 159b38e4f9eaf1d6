// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/evaluation_text.h"

#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace semantic_kiss::cli {
namespace {

std::string Figure(const std::optional<double>& value, int decimals, const char* unit) {
  return value.has_value() ? absl::StrFormat("%.*f %s", decimals, *value, unit) : "-";
}

std::optional<double> TimesHundred(const std::optional<double>& value) {
  if (!value.has_value()) return std::nullopt;
  return 100. * *value;
}

}  // namespace

std::string EvaluationText(const evaluation::Evaluation& evaluation, int num_poses) {
  const evaluation::Metrics metrics = evaluation::MetricsOf(evaluation);
  const evaluation::DriftError& last = evaluation.final_error;
  return absl::StrCat(
      absl::StrFormat("driven     %.1f m, %d poses\n", evaluation.driven_m, num_poses),
      "RTE        ", Figure(metrics.rte_percent, 4, "%"), ", ",
      Figure(TimesHundred(metrics.rte_deg_per_m), 4, "deg/100 m"), "\n", "ATE-3D     ",
      Figure(metrics.ate_3d_m, 3, "m"), "\n", "ATE-2D     ", Figure(metrics.ate_2d_m, 3, "m"), "\n",
      absl::StrFormat("last pose  off by %.3f m (height %+.3f m), %.2f deg (heading %+.2f deg)\n",
                      last.position_error_m, last.height_error_m, last.rotation_error_deg,
                      last.heading_error_deg));
}

}  // namespace semantic_kiss::cli
