// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/drive.h"

#include <memory>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/io/stock_grid.h"
#include "semantic_kiss/cli/live_snapshot.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/evaluation/final_error.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::common::StageTime;
using cartographer::slam::LocalResult;
using cartographer::slam::MapBuilder;

std::optional<double> CurrentError(const dataset::ScanSource& scans,
                                   const MapBuilder& map_builder) {
  if (!scans.ground_truth().has_value()) return std::nullopt;
  const auto& truth = *scans.ground_truth();
  const auto& estimate = map_builder.scan_poses();
  return evaluation::ComputeDriftError(
             {truth.front(), truth[estimate.size() - 1]},
             {estimate.front().local_from_sensor, estimate.back().local_from_sensor},
             evaluation::VehicleFrame::kLidar)
      .position_error_m;
}

// Of submaps that took their last scan: a map that cannot be written is to be told at once, not
// when all of the drive is in it.
absl::Status CheckCanBeWritten(const LocalResult& result) {
  if (!result.insertion.has_value()) return absl::OkStatus();
  for (const auto& [index, submap] : result.insertion->submaps) {
    if (!submap->finished) continue;
    RETURN_IF_ERROR(cartographer::common::AddContext(
        cartographer::io::CheckFitsStockGrid(submap->grid, submap->local_from_submap),
        absl::StrCat("submap ", index)));
  }
  return absl::OkStatus();
}

void Book(const LocalResult& result, DriveRecord* record) {
  ++record->num_scans;
  ++record->outcomes[result.outcome];
  for (const StageTime& time : result.stage_times) {
    record->stage_times.Add(time.stage, time.seconds);
  }
}

}  // namespace

absl::StatusOr<DriveRecord> Drive(dataset::ScanSource* scans, MapBuilder* map_builder,
                                  const DriveWatch& watch) {
  DriveRecord record;
  cartographer::common::Stopwatch whole;
  const double begin_s = SteadySeconds();
  for (int i = 0; i < scans->size() && !StopRequested(); ++i) {
    cartographer::common::Stopwatch reading;
    ASSIGN_OR_RETURN(const cartographer::sensor::LabeledScan scan, scans->Read(i));
    const double reading_s = reading.Lap();
    record.stage_times.Add("reading", reading_s);
    record.num_points += static_cast<int64_t>(scan.points.size());
    if (i == 0) {
      RETURN_IF_ERROR(CheckScansToTrace(watch.scans_to_trace, scan.index, scans->size()));
    }
    const bool traced = watch.scans_to_trace.count(scan.index) > 0;
    if (traced) record.traces.emplace_back();
    const LocalResult result = traced
                                   ? AddTraced(scan, reading_s, map_builder, &record.traces.back())
                                   : map_builder->AddScan(scan);
    RETURN_IF_ERROR(CheckCanBeWritten(result));
    Book(result, &record);
    const std::optional<double> error_m = CurrentError(*scans, *map_builder);
    watch.progress->Update(record.num_scans, error_m);
    const bool last = i + 1 == scans->size() || StopRequested();
    if (watch.board != nullptr && (last || watch.board->Wanted())) {
      auto snapshot = std::make_shared<live::Snapshot>(TakeSnapshot(record, *map_builder));
      snapshot->total = scans->size();
      snapshot->elapsed_s = SteadySeconds() - begin_s;
      snapshot->error_m = error_m;
      watch.board->Put(std::move(snapshot));
    }
  }
  record.elapsed_s = whole.Lap();
  watch.progress->Finish();
  return record;
}

}  // namespace semantic_kiss::cli
