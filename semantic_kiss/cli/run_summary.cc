// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_summary.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "semantic_kiss/cli/peak_memory.h"
#include "semantic_kiss/cli/run_text.h"
#include "semantic_kiss/cli/summary_line.h"

namespace semantic_kiss::cli {
namespace {

std::string AccuracyLine(const evaluation::Evaluation& evaluation) {
  const evaluation::Metrics metrics = evaluation::MetricsOf(evaluation);
  return absl::StrCat(
      "RTE ", FigureText(metrics.rte_percent, 3, "%"), ", ATE-3D ",
      FigureText(metrics.ate_3d_m, 3, "m"), ", ATE-2D ", FigureText(metrics.ate_2d_m, 3, "m"),
      absl::StrFormat(", last pose off by %.3f m", evaluation.final_error.position_error_m));
}

}  // namespace

std::string RunSummary(const RunResult& result, const std::string& directory,
                       const Terminal& terminal) {
  const bool complete = result.drive.num_scans == result.scans_available;
  std::string summary =
      SummaryLine(terminal, complete ? Style::kGreen : Style::kYellow, "scans",
                  absl::StrFormat("%s, %.1f a second, peak memory %.0f MiB", ScansText(result),
                                  ScansPerSecond(result.drive), PeakMemory_mib()));
  const auto add = [&](absl::string_view heading, const std::string& text) {
    summary += SummaryLine(terminal, Style::kBold, heading, text);
  };
  add("odometry", OutcomesText(result.drive));
  add("map",
      absl::StrFormat("%d nodes, %d submaps", result.map.nodes.size(), result.map.submaps.size()));
  if (!result.closures.verdicts.empty()) add("loops", ClosuresLine(result.closures));
  if (result.evaluation.has_value()) add("accuracy", AccuracyLine(*result.evaluation));
  if (!result.unknown_label_ids.empty())
    add("unlabeled", UnknownLabelsText(result.unknown_label_ids));
  for (const std::string& note : result.notes) add("note", note);
  // As it is: a path may hold blanks.
  return absl::StrCat(summary, Styled(terminal, Style::kBold, "output"), "    ", directory, "\n");
}

}  // namespace semantic_kiss::cli
