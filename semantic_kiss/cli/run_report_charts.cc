// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_report_charts.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "semantic_kiss/evaluation/relative_error.h"
#include "semantic_kiss/report/along_path.h"

namespace semantic_kiss::cli {
namespace {

using evaluation::RelativeErrorOfLength;
using report::Chart;
using report::Role;
using report::Series;

bool HasClosures(const RunResult& result) { return !result.closures.closures.empty(); }

Chart AlongTheWay(const RunResult& result, const char* heading, const char* note) {
  Chart chart;
  chart.heading = heading;
  chart.note = note;
  chart.kind = Chart::Kind::kLine;
  chart.x_name = "m driven";
  chart.y_name = "m";
  chart.x = evaluation::DrivenDistances(result.map_from_lidar);
  chart.along_path = true;
  return chart;
}

Chart HeightChart(const RunResult& result) {
  Chart chart = AlongTheWay(result, "Height", "Of the lidar above its start.");
  chart.series.push_back({"map", Role::kTrajectory, report::Heights(result.map_from_lidar)});
  if (HasClosures(result)) {
    chart.series.push_back({"odometry", Role::kOdometry, report::Heights(result.OdometryInMap())});
  }
  if (!result.true_lidar_poses.empty()) {
    const double start = result.map_from_lidar.front().translation().z();
    Series truth{"ground truth", Role::kGroundTruth, {}};
    for (const auto& pose : report::AlignedOnto(result.map_from_lidar, result.true_lidar_poses)) {
      truth.values.push_back(pose.translation().z() - start);
    }
    chart.series.push_back(std::move(truth));
    chart.note += " The truth lies where all of it fits best, so it need not begin at 0.";
  }
  return chart;
}

Chart ErrorChart(const RunResult& result) {
  Chart chart = AlongTheWay(result, "Error along the way",
                            "Distance from the true position after best-fit alignment of the whole "
                            "drive, so that it does not begin at 0.");
  chart.series.push_back({"map", Role::kTrajectory, result.evaluation->absolute_3d->errors_m});
  if (HasClosures(result)) {
    chart.series.push_back(
        {"odometry", Role::kOdometry, result.odometry_evaluation->absolute_3d->errors_m});
  }
  return chart;
}

using Lengths = std::vector<RelativeErrorOfLength>;

// What `value` makes of the errors of lengths that have segments.
template <typename Value>
Chart SegmentChart(const RunResult& result, const Value& value) {
  Chart chart;
  chart.kind = Chart::Kind::kColumns;
  chart.x_name = "length of the segments, m";
  const auto values = [&](const Lengths& lengths) {
    std::vector<double> list;
    for (const auto& length : lengths) {
      if (length.error.num_segments > 0) list.push_back(value(length.error));
    }
    return list;
  };
  const Lengths& lengths = result.evaluation->relative->by_length;
  for (const auto& length : lengths) {
    if (length.error.num_segments > 0) chart.categories.push_back(absl::StrCat(length.length_m));
  }
  chart.series.push_back({"map", Role::kTrajectory, values(lengths)});
  if (HasClosures(result)) {
    chart.series.push_back(
        {"odometry", Role::kOdometry, values(result.odometry_evaluation->relative->by_length)});
  }
  return chart;
}

Chart TranslationChart(const RunResult& result) {
  Chart chart = SegmentChart(
      result, [](const evaluation::RelativeError& error) { return error.translation_percent; });
  chart.heading = "Drift by length";
  chart.note = "Error of the motion over segments of the way (KITTI's RTE).";
  chart.y_name = "%";
  return chart;
}

Chart RotationChart(const RunResult& result) {
  Chart chart = SegmentChart(result, [](const evaluation::RelativeError& error) {
    return 100. * error.rotation_deg_per_m;
  });
  chart.heading = "Drift in rotation";
  chart.note = "The same for the angle.";
  chart.y_name = "°/100 m";
  return chart;
}

Chart CorrectionChart(const RunResult& result) {
  Chart chart = AlongTheWay(result, "Correction by loop closure",
                            "Distance between a scan's place in the map and where the odometry "
                            "alone had it.");
  chart.series.push_back({"correction", Role::kTrajectory,
                          report::Distances(result.map_from_lidar, result.OdometryInMap())});
  return chart;
}

Chart StageChart(const RunResult& result) {
  Chart chart;
  chart.heading = "Time of the stages";
  chart.note =
      "In total; some stages run in parallel. The parts of the odometry are within its time.";
  chart.kind = Chart::Kind::kRows;
  chart.y_name = "s";
  Series series{"total", Role::kTrajectory, {}};
  auto summaries = result.drive.stage_times.Summaries();
  std::stable_sort(summaries.begin(), summaries.end(), [](const auto& a, const auto& b) {
    return a.second.total_s > b.second.total_s;
  });
  for (const auto& [stage, summary] : summaries) {
    chart.categories.push_back(stage);
    series.values.push_back(summary.total_s);
  }
  chart.series.push_back(std::move(series));
  return chart;
}

}  // namespace

std::vector<Chart> RunCharts(const RunResult& result) {
  std::vector<Chart> charts = {HeightChart(result)};
  if (result.evaluation.has_value() && result.evaluation->absolute_3d.has_value()) {
    charts.push_back(ErrorChart(result));
  }
  if (result.evaluation.has_value() && result.evaluation->relative.has_value()) {
    charts.push_back(TranslationChart(result));
    charts.push_back(RotationChart(result));
  }
  if (HasClosures(result)) charts.push_back(CorrectionChart(result));
  charts.push_back(StageChart(result));
  return charts;
}

}  // namespace semantic_kiss::cli
