// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/map_info.h"

#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::common::ToSeconds;
using cartographer::common::ToUnixSeconds;
using cartographer::io::MapSummary;
using cartographer::sensor::Label;
using Json = nlohmann::ordered_json;

std::string Mib(uint64_t bytes) {
  return absl::StrFormat("%.2f MiB", static_cast<double>(bytes) / (1 << 20));
}

std::string Line(const char* heading, const std::string& text) {
  return absl::StrFormat("%-12s %s\n", heading, text);
}

std::string LabelTable(const MapSummary& summary) {
  std::string table = absl::StrFormat("\n%-20s %12s %14s %12s\n", "label", "grid hits",
                                      "submap points", "node points");
  for (size_t i = 0; i < summary.label_counts.size(); ++i) {
    const cartographer::map::LabelCount& count = summary.label_counts[i];
    if (count.IsZero()) continue;
    absl::StrAppendFormat(&table, "%-20s %12d %14d %12d\n",
                          summary.labels.Name(Label{static_cast<uint8_t>(i)}), count.hits,
                          count.submap_points, count.node_points);
  }
  return table;
}

std::string RecordTable(const MapSummary& summary) {
  std::string table =
      absl::StrFormat("\n%-32s %8s %12s %12s\n", "records", "count", "stored", "unpacked");
  for (const MapSummary::Kind& kind : summary.kinds) {
    absl::StrAppendFormat(&table, "%-32s %8d %12s %12s\n", kind.name, kind.count,
                          Mib(kind.stored_bytes), Mib(kind.message_bytes));
  }
  return table;
}

template <typename Box>
Json Bounds(const Box& box) {
  if (box.isEmpty()) return Json();
  const auto list = [](const auto& point) {
    return std::vector<double>(point.data(), point.data() + point.size());
  };
  return {{"min", list(box.min())}, {"max", list(box.max())}};
}

Json Trajectory(const MapSummary::Trajectory& trajectory) {
  Json json = {{"id", trajectory.id},
               {"nodes", trajectory.num_nodes},
               {"submaps", trajectory.num_submaps},
               {"length_m", trajectory.length_m}};
  const bool has_times = trajectory.num_nodes > 0;
  json["first_time_s"] = has_times ? Json(ToUnixSeconds(trajectory.first_time)) : Json();
  json["last_time_s"] = has_times ? Json(ToUnixSeconds(trajectory.last_time)) : Json();
  return json;
}

Json Labels(const MapSummary& summary) {
  Json labels = Json::object();
  for (size_t i = 0; i < summary.label_counts.size(); ++i) {
    const cartographer::map::LabelCount& count = summary.label_counts[i];
    if (count.IsZero()) continue;
    labels[summary.labels.Name(Label{static_cast<uint8_t>(i)})] = {
        {"hits", count.hits},
        {"submap_points", count.submap_points},
        {"node_points", count.node_points}};
  }
  return labels;
}

}  // namespace

std::string MapInfoText(const MapSummary& summary) {
  std::string text =
      Line("file", absl::StrCat(Mib(summary.file_bytes), ", format ", summary.format_version,
                                summary.made_by_us ? "" : ", not made by semantic_kiss"));
  for (const std::string& entry : summary.history) text += Line("history", entry);
  for (const MapSummary::Trajectory& trajectory : summary.trajectories) {
    const double duration_s =
        trajectory.num_nodes > 0 ? ToSeconds(trajectory.last_time - trajectory.first_time) : 0.;
    text += Line("trajectory",
                 absl::StrFormat("%d: %d nodes, %d submaps, %.1f m, %.1f s", trajectory.id,
                                 trajectory.num_nodes, trajectory.num_submaps, trajectory.length_m,
                                 duration_s));
  }
  text += Line("constraints",
               absl::StrFormat("%d within submaps, %d loop closures", summary.num_intra_constraints,
                               summary.num_inter_constraints));
  if (!summary.grid_bounds_m.isEmpty()) {
    const Eigen::Vector2d size_m = summary.grid_bounds_m.sizes();
    text += Line("extent", absl::StrFormat("%.1f m x %.1f m", size_m.x(), size_m.y()));
  }
  if (summary.num_unsupported_submaps > 0) {
    text += Line("unsupported", absl::StrCat(summary.num_unsupported_submaps,
                                             " submaps; the map cannot be opened"));
  }
  if (summary.made_by_us) {
    text += Line("label set", summary.labels.name());
    text += LabelTable(summary);
  }
  return text + RecordTable(summary);
}

Json MapInfoJson(const MapSummary& summary) {
  Json json;
  json["file_bytes"] = summary.file_bytes;
  json["format_version"] = summary.format_version;
  json["made_by_us"] = summary.made_by_us;
  json["trajectories"] = Json::array();
  for (const auto& trajectory : summary.trajectories) {
    json["trajectories"].push_back(Trajectory(trajectory));
  }
  json["constraints"] = {{"intra", summary.num_intra_constraints},
                         {"inter", summary.num_inter_constraints}};
  json["unsupported_submaps"] = summary.num_unsupported_submaps;
  json["label_set"] = summary.labels.name();
  json["labels"] = Labels(summary);
  json["node_bounds_m"] = Bounds(summary.node_bounds_m);
  json["grid_bounds_m"] = Bounds(summary.grid_bounds_m);
  json["history"] = summary.history;
  json["configuration"] = summary.configuration_lua;
  json["records"] = Json::array();
  for (const MapSummary::Kind& kind : summary.kinds) {
    json["records"].push_back({{"kind", kind.name},
                               {"count", kind.count},
                               {"stored_bytes", kind.stored_bytes},
                               {"message_bytes", kind.message_bytes}});
  }
  return json;
}

}  // namespace semantic_kiss::cli
