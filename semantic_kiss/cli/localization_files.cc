// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/localization_files.h"

#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/cli/peak_memory.h"
#include "semantic_kiss/cli/version.h"
#include "semantic_kiss/report/json_text.h"

namespace semantic_kiss::cli {
namespace {

namespace io = cartographer::io;
using cartographer::slam::LocalizedScan;
using cartographer::transform::Rigid3d;
using Json = nlohmann::ordered_json;
using MaybePoses = std::vector<std::optional<Rigid3d>>;

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

// The scans that have a pose, with their times.
absl::Status WriteTum(const io::Destination& destination, const Localization& localization,
                      const MaybePoses& map_from_sensor) {
  std::vector<cartographer::common::Time> times;
  std::vector<Rigid3d> poses;
  for (size_t i = 0; i < map_from_sensor.size(); ++i) {
    if (!map_from_sensor[i].has_value()) continue;
    times.push_back(localization.scans[i].time);
    poses.push_back(*map_from_sensor[i]);
  }
  return io::WriteTumPoses(destination, times, poses);
}

std::vector<Rigid3d> LocalizedPoses(const Localization& localization,
                                    const std::optional<Rigid3d>& camera_from_sensor) {
  std::vector<Rigid3d> poses;
  for (const LocalizedScan& scan : localization.scans) {
    if (scan.map_from_sensor.has_value()) poses.push_back(*scan.map_from_sensor);
  }
  if (!camera_from_sensor.has_value()) return poses;
  return io::PosesOfOtherBody(poses, *camera_from_sensor);
}

Json Poses(const Localization& localization) {
  Json poses = Json::array();
  for (size_t i = 0; i < localization.scans.size(); ++i) {
    const LocalizedScan& scan = localization.scans[i];
    const bool localized = scan.map_from_sensor.has_value();
    Json json = {{"scan", localization.first_scan + static_cast<int>(i)},
                 {"state", StateName(scan.state)},
                 {"reason", scan.reason},
                 {"localized", localized},
                 {"score", localized ? Json(scan.score) : Json()},
                 {"since_match_m", localized ? Json(scan.since_match_m) : Json()}};
    if (!localization.errors.empty()) {
      const auto& error = localization.errors[i];
      json["position_error_m"] = error ? Json(error->position_m) : Json();
      json["heading_error_deg"] = error ? Json(error->heading_deg) : Json();
    }
    poses.push_back(std::move(json));
  }
  return poses;
}

// Where the state changes.
Json Events(const Localization& localization) {
  Json events = Json::array();
  for (size_t i = 0; i < localization.scans.size(); ++i) {
    const LocalizedScan& scan = localization.scans[i];
    if (i > 0 && localization.scans[i - 1].state == scan.state) continue;
    events.push_back({{"scan", localization.first_scan + static_cast<int>(i)},
                      {"state", StateName(scan.state)},
                      {"reason", scan.reason}});
  }
  return events;
}

Json Metrics(const Localization& localization) {
  const evaluation::LocalizationMetrics metrics = evaluation::Summarize(localization.errors);
  const bool known = !localization.errors.empty();
  return {{"position_error_median_m", OrNull(metrics.position_median_m)},
          {"position_error_p95_m", OrNull(metrics.position_p95_m)},
          {"position_error_max_m", OrNull(metrics.position_max_m)},
          {"heading_error_median_deg", OrNull(metrics.heading_median_deg)},
          {"heading_error_p95_deg", OrNull(metrics.heading_p95_deg)},
          {"wrong_places", known ? Json(metrics.wrong_places) : Json()}};
}

}  // namespace

Json LocalizationJson(const Localization& localization, const LocalizationContext& context) {
  const auto num_scans = static_cast<int>(localization.scans.size());
  const std::optional<int> first_fix = localization.FirstFix();
  Json json;
  json["version"] = Version();
  json["config"] = context.configuration_lua;
  json["map"] = context.map_file;
  json["map_sha256_before"] = context.map_sha256_before;
  json["map_sha256_after"] = context.map_sha256_after;
  json["map_loading_s"] = context.map_loading_s;
  json["scans"] = num_scans;
  json["scans_available"] = context.scans_available;
  json["first_fix_scan"] = first_fix ? Json(localization.first_scan + *first_fix) : Json();
  json["first_fix_after_scans"] = first_fix ? Json(*first_fix) : Json();
  json["events"] = Events(localization);
  json["stages"] = ToJson(localization.stage_times);
  json["scans_per_second"] =
      localization.elapsed_s > 0. ? Json(num_scans / localization.elapsed_s) : Json();
  json["peak_memory_mib"] = PeakMemory_mib();
  json["memory_mib_every_500_scans"] = localization.memory_mib;
  json["odometry_outcomes"] = localization.outcomes;
  json["candidates"] = localization.verdicts;
  json["metrics"] = Metrics(localization);
  json["poses"] = Poses(localization);
  return json;
}

absl::Status WriteLocalizationFiles(const OutputDirectory& directory,
                                    const Localization& localization,
                                    const LocalizationContext& context) {
  io::AtomicFileSet files;
  const auto file = [&](const char* name) {
    return io::Destination(directory.FileNamed(name), &files);
  };
  RETURN_IF_ERROR(io::WriteKittiPoses(file("relocalization_kitti.txt"),
                                      LocalizedPoses(localization, context.camera_from_sensor)));
  RETURN_IF_ERROR(
      WriteTum(file("relocalization_tum.txt"), localization, localization.CausalPoses()));
  RETURN_IF_ERROR(WriteTum(file("smoothed_tum.txt"), localization, localization.smoothed));
  RETURN_IF_ERROR(io::WriteFileAtomically(
      file("relocalization.json"),
      absl::StrCat(report::JsonText(LocalizationJson(localization, context), 2), "\n")));
  return files.Commit();
}

}  // namespace semantic_kiss::cli
