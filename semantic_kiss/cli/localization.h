// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_LOCALIZATION_H_
#define SEMANTIC_KISS_CLI_LOCALIZATION_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/slam/relocalizer.h"
#include "semantic_kiss/cli/progress.h"
#include "semantic_kiss/cli/stage_times.h"
#include "semantic_kiss/dataset/scan_source.h"
#include "semantic_kiss/evaluation/localization_error.h"

namespace semantic_kiss::cli {

// A drive through a map, as it was localized.
struct Localization {
  int first_scan = 0;  // its number in the files
  // One for each scan until a signal stopped the drive; without their stage times.
  std::vector<cartographer::slam::LocalizedScan> scans;
  // As it was known in the end; as many.
  std::vector<std::optional<cartographer::transform::Rigid3d>> smoothed;
  std::map<std::string, int> outcomes;  // of the odometry
  cartographer::pose_graph::VerdictCounts verdicts;
  StageTimes stage_times;
  double elapsed_s = 0.;
  // Resident memory [MiB] after every so many scans.
  static constexpr int kScansPerMemorySample = 500;
  std::vector<double> memory_mib;
  // Where the ground truth of both the drive and the map is known: as many as scans, else empty.
  std::vector<std::optional<evaluation::LocalizationError>> errors;

  std::vector<std::optional<cartographer::transform::Rigid3d>> CausalPoses() const;
  // Index of the first scan that was localized.
  std::optional<int> FirstFix() const;
};

// Feeds the scans to the relocalizer, to the last one or until StopRequested(). Fails if a scan
// cannot be read.
absl::StatusOr<Localization> Localize(dataset::ScanSource* scans,
                                      cartographer::slam::Relocalizer* relocalizer,
                                      ProgressReporter* progress);

// Where the places of a map really are: its nodes, by their times, among the poses of the sequence
// that it was made from (poses.txt, times.txt, and calib.txt if poses are a camera's). Errors name
// the file; NotFound if no node's time is among the sequence's.
absl::StatusOr<std::vector<evaluation::MappedPlace>> ReadMappedPlaces(
    const cartographer::map::Map& map, const std::string& sequence_directory);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_LOCALIZATION_H_
