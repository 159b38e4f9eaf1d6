// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_json.h"

#include <string>

#include "semantic_kiss/cli/peak_memory.h"
#include "semantic_kiss/cli/trace_text.h"
#include "semantic_kiss/cli/version.h"

namespace semantic_kiss::cli {
namespace {

using Json = nlohmann::ordered_json;

Json UnknownLabelIds(const dataset::UnknownLabelIds& ids) {
  Json json = Json::object();
  for (const auto& [id, num_points] : ids) json[std::to_string(id)] = num_points;
  return json;
}

Json LastPose(const evaluation::DriftError& error) {
  return {{"error_m", error.position_error_m},
          {"error_deg", error.rotation_error_deg},
          {"height_error_m", error.height_error_m}};
}

}  // namespace

Json RunJson(const RunResult& result) {
  const DriveRecord& drive = result.drive;
  Json json;
  json["version"] = Version();
  json["config"] = result.map.configuration_lua;
  json["scans"] = drive.num_scans;
  json["scans_available"] = result.scans_available;
  json["scan_points"] = drive.num_points;
  json["stages"] = ToJson(drive.stage_times);
  json["scans_per_second"] =
      drive.elapsed_s > 0. ? Json(drive.num_scans / drive.elapsed_s) : Json();
  json["peak_memory_mib"] = PeakMemory_mib();
  json["odometry_outcomes"] = drive.outcomes;
  json["unknown_label_ids"] = UnknownLabelIds(result.unknown_label_ids);
  json["map"] = {{"nodes", result.map.nodes.size()},
                 {"submaps", result.map.submaps.size()},
                 {"constraints", result.map.constraints.size()}};
  json["loop_closures"] = ClosuresJson(result.closures);
  json["closure_search"] = ClosureSearchJson(result.closures);
  json["metrics"] = evaluation::ToJson(result.evaluation ? evaluation::MetricsOf(*result.evaluation)
                                                         : evaluation::Metrics());
  json["last_pose"] = result.evaluation ? LastPose(result.evaluation->final_error) : Json();
  json["notes"] = result.notes;
  json["traces"] = Json::array();
  for (const TracedScan& traced : drive.traces) {
    json["traces"].push_back(TraceJson(traced, result.map.labels));
  }
  return json;
}

}  // namespace semantic_kiss::cli
