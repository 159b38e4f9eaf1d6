// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_DRIVE_H_
#define SEMANTIC_KISS_CLI_DRIVE_H_

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/slam/map_builder.h"
#include "semantic_kiss/cli/progress.h"
#include "semantic_kiss/cli/stage_times.h"
#include "semantic_kiss/cli/traced_scan.h"
#include "semantic_kiss/dataset/scan_source.h"
#include "semantic_kiss/live/board.h"

namespace semantic_kiss::cli {

// What is to be told of a drive beside its poses and its map.
struct DriveRecord {
  int num_scans = 0;  // fewer than there are if a signal stopped the drive
  std::map<std::string, int> outcomes;
  int64_t num_points = 0;
  double elapsed_s = 0.;
  StageTimes stage_times;
  std::vector<TracedScan> traces;
};

// Who looks on while the drive goes on; none of it has an influence on the results.
struct DriveWatch {
  ProgressReporter* progress = nullptr;  // never null
  std::set<int> scans_to_trace;          // by their numbers in the sequence
  live::Board* board = nullptr;          // of a page; null: there is none
};

// Feeds the scans to the map builder, one after the other, to the last one or until
// StopRequested(). Fails if a scan cannot be read, or if one that is to be traced is not among
// them.
absl::StatusOr<DriveRecord> Drive(dataset::ScanSource* scans,
                                  cartographer::slam::MapBuilder* map_builder,
                                  const DriveWatch& watch);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_DRIVE_H_
