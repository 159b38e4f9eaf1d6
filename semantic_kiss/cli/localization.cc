// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/localization.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/cli/resident_memory.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/dataset/scan_times.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::slam::LocalizedScan;
using cartographer::transform::Rigid3d;

std::string Note(const LocalizedScan& scan) {
  const absl::string_view state = cartographer::slam::StateName(scan.state);
  return scan.reason.empty() ? std::string(state) : absl::StrCat(state, " (", scan.reason, ")");
}

void Book(LocalizedScan scan, Localization* localization) {
  ++localization->outcomes[scan.outcome];
  for (const auto& time : std::exchange(scan.stage_times, {})) {
    localization->stage_times.Add(time.stage, time.seconds);
  }
  localization->scans.push_back(std::move(scan));
  if (localization->scans.size() % Localization::kScansPerMemorySample == 0) {
    localization->memory_mib.push_back(ResidentMemory_mib());
  }
}

// The poses of the sequence's lidar.
absl::StatusOr<std::vector<Rigid3d>> ReadLidarPoses(const std::string& directory) {
  ASSIGN_OR_RETURN(const std::vector<Rigid3d> poses,
                   cartographer::io::ReadKittiPoses(absl::StrCat(directory, "/poses.txt")));
  const auto camera_from_lidar =
      cartographer::io::ReadKittiCalibration(absl::StrCat(directory, "/calib.txt"));
  if (absl::IsNotFound(camera_from_lidar.status())) return poses;
  RETURN_IF_ERROR(camera_from_lidar.status());
  return cartographer::io::PosesOfOtherBody(poses, camera_from_lidar->inverse());
}

}  // namespace

std::vector<std::optional<Rigid3d>> Localization::CausalPoses() const {
  std::vector<std::optional<Rigid3d>> poses;
  for (const LocalizedScan& scan : scans) poses.push_back(scan.map_from_sensor);
  return poses;
}

std::optional<int> Localization::FirstFix() const {
  for (size_t i = 0; i < scans.size(); ++i) {
    if (scans[i].map_from_sensor.has_value()) return static_cast<int>(i);
  }
  return std::nullopt;
}

absl::StatusOr<Localization> Localize(dataset::ScanSource* scans,
                                      cartographer::slam::Relocalizer* relocalizer,
                                      ProgressReporter* progress) {
  Localization localization;
  cartographer::common::Stopwatch whole;
  for (int i = 0; i < scans->size() && !StopRequested(); ++i) {
    cartographer::common::Stopwatch reading;
    ASSIGN_OR_RETURN(const cartographer::sensor::LabeledScan scan, scans->Read(i));
    localization.stage_times.Add("reading", reading.Lap());
    if (i == 0) localization.first_scan = scan.index;
    LocalizedScan localized = relocalizer->AddScan(scan);
    progress->Update(i + 1, std::nullopt, Note(localized));
    Book(std::move(localized), &localization);
  }
  localization.elapsed_s = whole.Lap();
  progress->Finish();
  localization.smoothed = relocalizer->Finish();
  localization.verdicts = relocalizer->verdicts();
  return localization;
}

absl::StatusOr<std::vector<evaluation::MappedPlace>> ReadMappedPlaces(
    const cartographer::map::Map& map, const std::string& sequence_directory) {
  ASSIGN_OR_RETURN(const std::vector<Rigid3d> world_from_lidar, ReadLidarPoses(sequence_directory));
  ASSIGN_OR_RETURN(const auto times,
                   dataset::ReadScanTimes(absl::StrCat(sequence_directory, "/times.txt")));
  std::map<cartographer::common::Time, size_t> scan_at_time;
  for (size_t i = 0; i < times.size() && i < world_from_lidar.size(); ++i) {
    scan_at_time[times[i]] = i;
  }
  std::vector<evaluation::MappedPlace> places;
  for (const auto& [id, node] : map.nodes) {
    const auto scan = scan_at_time.find(node.time);
    if (scan == scan_at_time.end()) continue;
    places.push_back({node.map_from_node, world_from_lidar[scan->second]});
  }
  if (places.empty()) {
    return absl::NotFoundError(
        absl::StrCat(sequence_directory,
                     "/times.txt: no node of the map has one of these times; "
                     "is it the sequence that the map was made from?"));
  }
  return places;
}

}  // namespace semantic_kiss::cli
