// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_report.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "semantic_kiss/cli/closure_verdict.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/configuration_difference.h"
#include "semantic_kiss/cli/peak_memory.h"
#include "semantic_kiss/cli/run_report_charts.h"
#include "semantic_kiss/cli/run_report_map.h"
#include "semantic_kiss/cli/run_text.h"
#include "semantic_kiss/cli/version.h"
#include "semantic_kiss/evaluation/relative_error.h"

namespace semantic_kiss::cli {
namespace {

using report::Figure;
using report::Table;

// The configuration that differences are told from.
constexpr char kDefaultConfiguration[] = "semantic_kiss.lua";
constexpr double kKilometre_m = 1000.;

double Driven_m(const RunResult& result) {
  return evaluation::DrivenDistances(result.map_from_lidar).back();
}

double Seconds(const RunResult& result) {
  return cartographer::common::ToSeconds(result.times.back() - result.times.front());
}

void AddAccuracy(const RunResult& result, std::vector<Figure>* figures) {
  if (!result.evaluation.has_value()) return;
  const evaluation::Metrics metrics = evaluation::MetricsOf(*result.evaluation);
  if (metrics.rte_percent.has_value()) {
    figures->push_back({"Drift", FigureText(metrics.rte_percent, 2, ""), "%",
                        "RTE, and " + FigureText(100. * *metrics.rte_deg_per_m, 2, "°/100 m")});
  }
  if (metrics.ate_3d_m.has_value()) {
    figures->push_back({"Error of position", FigureText(metrics.ate_3d_m, 2, ""), "m",
                        "ATE in space; " + FigureText(metrics.ate_2d_m, 2, "m in the plane")});
  }
}

std::vector<Figure> HeadlineFigures(const RunResult& result) {
  const double driven_m = Driven_m(result);
  std::vector<Figure> figures;
  const bool far = driven_m >= kKilometre_m;
  figures.push_back(
      {"Driven",
       far ? absl::StrFormat("%.2f", driven_m / kKilometre_m) : absl::StrFormat("%.0f", driven_m),
       far ? "km" : "m", absl::StrFormat("in %.0f s", Seconds(result))});
  AddAccuracy(result, &figures);
  if (!result.closures.verdicts.empty()) {
    int candidates = 0;
    for (const auto& [verdict, count] : result.closures.verdicts) candidates += count;
    std::string note = absl::StrCat("of ", candidates, " candidates");
    if (!result.closures.errors.empty()) {
      absl::StrAppend(&note, "; ", result.closures.NumFalse(), " false");
    }
    figures.push_back(
        {"Loop closures", absl::StrCat(result.closures.closures.size()), "", std::move(note)});
  }
  figures.push_back({"Speed", absl::StrFormat("%.1f", ScansPerSecond(result.drive)), "scans/s",
                     absl::StrFormat("%.1f s for all scans", result.drive.elapsed_s)});
  figures.push_back({"Peak memory", absl::StrFormat("%.0f", PeakMemory_mib()), "MiB",
                     absl::StrFormat("%d submaps, %d nodes", result.map.submaps.size(),
                                     result.map.nodes.size())});
  return figures;
}

// "1 drive, 1090 nodes, 109 submaps"; empty for a new map.
std::string EarlierText(const RunResult& result) {
  std::set<int> drives;
  int nodes = 0, submaps = 0;
  for (const auto& [id, node] : result.map.nodes) {
    if (id.trajectory_id == result.trajectory_id) continue;
    drives.insert(id.trajectory_id);
    ++nodes;
  }
  for (const auto& [id, submap] : result.map.submaps) {
    submaps += id.trajectory_id == result.trajectory_id ? 0 : 1;
  }
  if (drives.empty()) return "";
  return absl::StrFormat("%d %s, %d nodes, %d submaps", drives.size(),
                         drives.size() == 1 ? "drive" : "drives", nodes, submaps);
}

Table AboutTheRun(const RunResult& result) {
  Table table{"Run", "", {}, {}};
  table.rows = {
      {"scans", ScansText(result)},
      {"points", absl::StrCat(result.drive.num_points)},
      {"odometry", OutcomesText(result.drive)},
      {"map", absl::StrFormat("%d nodes, %d submaps, %d constraints", result.map.nodes.size(),
                              result.map.submaps.size(), result.map.constraints.size())},
      {"label set", result.map.labels.name()},
  };
  const std::string earlier = EarlierText(result);
  if (!earlier.empty()) table.rows.push_back({"of these before", earlier});
  if (!result.closures.verdicts.empty()) {
    table.rows.push_back({"loop closures", ClosuresLine(result.closures)});
  }
  if (!result.unknown_label_ids.empty()) {
    table.rows.push_back({"unknown labels", UnknownLabelsText(result.unknown_label_ids)});
  }
  for (const std::string& note : result.notes) table.rows.push_back({"note", note});
  return table;
}

// The figures of an evaluation, in the order of AccuracyNames().
std::vector<std::string> AccuracyFigures(const evaluation::Evaluation& evaluation) {
  const evaluation::Metrics metrics = evaluation::MetricsOf(evaluation);
  return {FigureText(metrics.rte_percent, 3, "%"), FigureText(metrics.rte_deg_per_m, 5, "°/m"),
          FigureText(metrics.ate_3d_m, 3, "m"), FigureText(metrics.ate_2d_m, 3, "m"),
          absl::StrFormat("%.3f m, %.2f°", evaluation.final_error.position_error_m,
                          evaluation.final_error.rotation_error_deg)};
}

std::vector<std::string> AccuracyNames() {
  return {"RTE, translation", "RTE, rotation", "ATE in space", "ATE in the plane", "last pose off"};
}

Table Accuracy(const RunResult& result) {
  if (!result.evaluation.has_value()) {
    return {"Accuracy", "", {}, {{"ground truth", "none"}}};
  }
  Table table{"Accuracy", "", {"", "map"}, {}};
  for (const std::string& name : AccuracyNames()) table.rows.push_back({name});
  const auto add_column = [&](const evaluation::Evaluation& evaluation) {
    const std::vector<std::string> figures = AccuracyFigures(evaluation);
    for (size_t i = 0; i < figures.size(); ++i) table.rows[i].push_back(figures[i]);
  };
  add_column(*result.evaluation);
  if (!result.closures.closures.empty()) {
    table.header.push_back("odometry");
    add_column(*result.odometry_evaluation);
  }
  return table;
}

std::vector<Table> Candidates(const RunResult& result) {
  if (result.closures.verdicts.empty()) return {};
  Table table{"Candidates for loop closure",
              "What became of the places that might have been seen before.",
              {"verdict", "candidates", ""},
              {}};
  std::vector<std::pair<std::string, int>> verdicts(result.closures.verdicts.begin(),
                                                    result.closures.verdicts.end());
  std::stable_sort(verdicts.begin(), verdicts.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  for (const auto& [verdict, count] : verdicts) {
    table.rows.push_back({verdict, absl::StrCat(count), MeaningOf(verdict)});
  }
  return {table};
}

Table StageTable(const StageTimes& times) {
  Table table{"Time of the stages", "", {"stage", "median ms", "95 % ms", "total s"}, {}};
  for (const auto& [stage, summary] : times.Summaries()) {
    table.rows.push_back({stage, absl::StrFormat("%.2f", summary.median_ms),
                          absl::StrFormat("%.2f", summary.p95_ms),
                          absl::StrFormat("%.2f", summary.total_s)});
  }
  return table;
}

std::vector<Table> ChangedOptions(const RunResult& result) {
  const auto defaults = LoadConfiguration(
      absl::StrCat(InstalledConfigurationDirectory(), "/", kDefaultConfiguration));
  if (!defaults.ok()) return {};
  Table table{"Changed options",
              absl::StrCat("Where the configuration differs from ", kDefaultConfiguration, "."),
              {"option", "here", "there"},
              {}};
  for (const auto& difference : Differences(result.map.configuration_lua, defaults->lua)) {
    table.rows.push_back({difference.key, difference.value, difference.other});
  }
  if (table.rows.empty()) table = {"Changed options", "", {}, {{"none", kDefaultConfiguration}}};
  return {table};
}

}  // namespace

report::Report RunReport(const RunResult& result, report::MapLayers layers) {
  report::Report report;
  const double driven_m = Driven_m(result);
  report.title = "A drive of " + (driven_m < kKilometre_m
                                      ? absl::StrFormat("%.0f m", driven_m)
                                      : absl::StrFormat("%.1f km", driven_m / kKilometre_m));
  report.subtitle = absl::StrCat("semantic_kiss ", Version(), ", ", ScansText(result), " scans");
  const std::string earlier = EarlierText(result);
  if (!earlier.empty()) absl::StrAppend(&report.subtitle, ", added to a map of ", earlier);
  report.figures = HeadlineFigures(result);
  report.maps.push_back(RunMapView(result, std::move(layers)));
  report.charts = RunCharts(result);
  report.tables = {AboutTheRun(result), Accuracy(result)};
  for (const auto& tables : {Candidates(result), ChangedOptions(result)}) {
    report.tables.insert(report.tables.end(), tables.begin(), tables.end());
  }
  report.tables.push_back(StageTable(result.drive.stage_times));
  report.code_heading = "The whole configuration";
  report.code = result.map.configuration_lua;
  return report;
}

}  // namespace semantic_kiss::cli
