// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_DRIVE_H_
#define SEMANTIC_KISS_CLI_DRIVE_H_

#include <cstdint>
#include <map>
#include <string>

#include "absl/status/statusor.h"
#include "cartographer/slam/map_builder.h"
#include "semantic_kiss/cli/progress.h"
#include "semantic_kiss/cli/stage_times.h"
#include "semantic_kiss/dataset/scan_source.h"

namespace semantic_kiss::cli {

// What is to be told of a drive beside its poses and its map.
struct DriveRecord {
  int num_scans = 0;  // fewer than there are if a signal stopped the drive
  std::map<std::string, int> outcomes;
  int64_t num_points = 0;
  double elapsed_s = 0.;
  StageTimes stage_times;
};

// Feeds the scans to the map builder, one after the other, to the last one or until
// StopRequested(). Fails if a scan cannot be read.
absl::StatusOr<DriveRecord> Drive(dataset::ScanSource* scans,
                                  cartographer::slam::MapBuilder* map_builder,
                                  ProgressReporter* progress);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_DRIVE_H_
