// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_report.h"

#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "semantic_kiss/cli/peak_memory.h"
#include "semantic_kiss/cli/summary_line.h"
#include "semantic_kiss/cli/version.h"
#include "semantic_kiss/report/html_report.h"

namespace semantic_kiss::cli {
namespace {

using report::Table;

std::string Scans(const RunResult& result) {
  if (result.drive.num_scans == result.scans_available) return absl::StrCat(result.drive.num_scans);
  return absl::StrCat(result.drive.num_scans, " of ", result.scans_available, " (stopped)");
}

std::string Outcomes(const DriveRecord& drive) {
  return absl::StrJoin(drive.outcomes, ", ", [](std::string* out, const auto& outcome) {
    absl::StrAppend(out, outcome.second, " ", outcome.first);
  });
}

double ScansPerSecond(const DriveRecord& drive) {
  return drive.elapsed_s > 0. ? drive.num_scans / drive.elapsed_s : 0.;
}

std::string UnknownLabels(const dataset::UnknownLabelIds& ids) {
  return absl::StrJoin(ids, ", ", [](std::string* out, const auto& id) {
    absl::StrAppend(out, "id ", id.first, ": ", id.second, " points");
  });
}

std::string Figure(const std::optional<double>& value, int decimals, const char* unit) {
  return value.has_value() ? absl::StrFormat("%.*f %s", decimals, *value, unit) : "-";
}

Table AboutTheRun(const RunResult& result) {
  Table table{"Run", {}, {}};
  table.rows = {
      {"scans", Scans(result)},
      {"points", absl::StrCat(result.drive.num_points)},
      {"odometry", Outcomes(result.drive)},
      {"speed", absl::StrFormat("%.1f scans/s", ScansPerSecond(result.drive))},
      {"peak memory", absl::StrFormat("%.0f MiB", PeakMemory_mib())},
      {"map", absl::StrFormat("%d nodes, %d submaps, %d constraints", result.map.nodes.size(),
                              result.map.submaps.size(), result.map.constraints.size())},
  };
  if (!result.closures.verdicts.empty()) {
    table.rows.push_back({"loop closures", ClosuresLine(result.closures)});
  }
  if (!result.unknown_label_ids.empty()) {
    table.rows.push_back({"unknown labels", UnknownLabels(result.unknown_label_ids)});
  }
  for (const std::string& note : result.notes) table.rows.push_back({"note", note});
  return table;
}

Table Accuracy(const std::optional<evaluation::Evaluation>& evaluation) {
  Table table{"Accuracy", {}, {}};
  if (!evaluation.has_value()) {
    table.rows = {{"ground truth", "none"}};
    return table;
  }
  const evaluation::Metrics metrics = evaluation::MetricsOf(*evaluation);
  table.rows = {
      {"driven", absl::StrFormat("%.1f m", evaluation->driven_m)},
      {"RTE, translation", Figure(metrics.rte_percent, 3, "%")},
      {"RTE, rotation", Figure(metrics.rte_deg_per_m, 5, "deg/m")},
      {"ATE in space", Figure(metrics.ate_3d_m, 3, "m")},
      {"ATE in the plane", Figure(metrics.ate_2d_m, 3, "m")},
      {"last pose",
       absl::StrFormat("%.3f m, %.2f deg off", evaluation->final_error.position_error_m,
                       evaluation->final_error.rotation_error_deg)},
  };
  return table;
}

Table StageTable(const StageTimes& times) {
  Table table{"Time of the stages", {"stage", "median ms", "95 % ms", "total s"}, {}};
  for (const auto& [stage, summary] : times.Summaries()) {
    table.rows.push_back({stage, absl::StrFormat("%.2f", summary.median_ms),
                          absl::StrFormat("%.2f", summary.p95_ms),
                          absl::StrFormat("%.2f", summary.total_s)});
  }
  return table;
}

std::string AccuracyLine(const evaluation::Evaluation& evaluation) {
  const evaluation::Metrics metrics = evaluation::MetricsOf(evaluation);
  return absl::StrCat(
      "RTE ", Figure(metrics.rte_percent, 3, "%"), ", ATE-3D ", Figure(metrics.ate_3d_m, 3, "m"),
      ", ATE-2D ", Figure(metrics.ate_2d_m, 3, "m"),
      absl::StrFormat(", last pose off by %.3f m", evaluation.final_error.position_error_m));
}

}  // namespace

std::string RunReport(const RunResult& result, absl::string_view map_image) {
  report::Page page;
  page.title = "Semantic KISS: report of a run";
  page.subtitle = absl::StrCat("semantic_kiss ", Version());
  page.image_png = std::string(map_image);
  page.tables = {AboutTheRun(result), Accuracy(result.evaluation),
                 StageTable(result.drive.stage_times)};
  page.code_heading = "Configuration";
  page.code = result.map.configuration_lua;
  return report::Html(page);
}

std::string RunSummary(const RunResult& result, const std::string& directory,
                       const Terminal& terminal) {
  const bool complete = result.drive.num_scans == result.scans_available;
  std::string summary =
      SummaryLine(terminal, complete ? Style::kGreen : Style::kYellow, "scans",
                  absl::StrFormat("%s, %.1f a second, peak memory %.0f MiB", Scans(result),
                                  ScansPerSecond(result.drive), PeakMemory_mib()));
  const auto add = [&](absl::string_view heading, const std::string& text) {
    summary += SummaryLine(terminal, Style::kBold, heading, text);
  };
  add("odometry", Outcomes(result.drive));
  add("map",
      absl::StrFormat("%d nodes, %d submaps", result.map.nodes.size(), result.map.submaps.size()));
  if (!result.closures.verdicts.empty()) add("loops", ClosuresLine(result.closures));
  if (result.evaluation.has_value()) add("accuracy", AccuracyLine(*result.evaluation));
  if (!result.unknown_label_ids.empty()) add("unlabeled", UnknownLabels(result.unknown_label_ids));
  for (const std::string& note : result.notes) add("note", note);
  // As it is: a path may hold blanks.
  return absl::StrCat(summary, Styled(terminal, Style::kBold, "output"), "    ", directory, "\n");
}

}  // namespace semantic_kiss::cli
