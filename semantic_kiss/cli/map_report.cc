// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/map_report.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"
#include "cartographer/map/label_count.h"
#include "glog/logging.h"
#include "semantic_kiss/cli/version.h"
#include "semantic_kiss/report/map_layers.h"
#include "semantic_kiss/report/map_view.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::map::Constraint;
using cartographer::map::Map;
using cartographer::sensor::Label;
using report::Table;

std::vector<std::string> HeaderOf(const std::vector<NamedMap>& maps) {
  std::vector<std::string> header = {""};
  for (const NamedMap& map : maps) header.push_back(map.name);
  return header;
}

// A row with what `value` tells of each map.
template <typename Value>
std::vector<std::string> RowOf(const char* name, const std::vector<NamedMap>& maps,
                               const Value& value) {
  std::vector<std::string> row = {name};
  for (const NamedMap& map : maps) row.push_back(absl::StrCat(value(map.map)));
  return row;
}

Table ContentTable(const std::vector<NamedMap>& maps) {
  Table table{"Content", "", HeaderOf(maps), {}};
  table.rows = {
      RowOf("nodes", maps, [](const Map& map) { return map.nodes.size(); }),
      RowOf("submaps", maps, [](const Map& map) { return map.submaps.size(); }),
      RowOf("loop closures", maps,
            [](const Map& map) {
              return std::count_if(map.constraints.begin(), map.constraints.end(),
                                   [](const Constraint& constraint) {
                                     return constraint.kind == Constraint::Kind::kInterSubmap;
                                   });
            }),
      RowOf("label set", maps, [](const Map& map) { return map.labels.name(); }),
      RowOf("history", maps, [](const Map& map) { return absl::StrJoin(map.history, "; "); })};
  return table;
}

// Hits in the grids by the names of labels, of those that occur.
std::map<std::string, uint64_t> HitsOf(const Map& map) {
  std::map<std::string, uint64_t> hits;
  const cartographer::map::LabelCounts counts = cartographer::map::CountMap(map);
  for (size_t i = 0; i < counts.size(); ++i) {
    if (counts[i].hits == 0) continue;
    hits.emplace(map.labels.Name(Label{static_cast<uint8_t>(i)}), counts[i].hits);
  }
  return hits;
}

Table LabelTable(const std::vector<NamedMap>& maps) {
  Table table{"Labels", "Hits in the grids.", HeaderOf(maps), {}};
  std::map<std::string, std::vector<std::string>> rows;
  for (size_t i = 0; i < maps.size(); ++i) {
    for (const auto& [name, hits] : HitsOf(maps[i].map)) {
      std::vector<std::string>& row = rows[name];
      if (row.empty()) row.assign(maps.size() + 1, "-");
      row[0] = name;
      row[i + 1] = absl::StrCat(hits);
    }
  }
  for (const auto& entry : rows) table.rows.push_back(entry.second);
  return table;
}

}  // namespace

absl::StatusOr<report::Report> MapReport(const std::vector<NamedMap>& maps,
                                         const cartographer::io::proto::RenderOptions& image,
                                         const report::proto::ReportOptions& options) {
  CHECK(!maps.empty());
  std::vector<const Map*> contents;
  for (const NamedMap& map : maps) contents.push_back(&map.map);
  ASSIGN_OR_RETURN(std::vector<report::MapLayers> layers,
                   report::TakeApart(contents, image, options));
  report::Report report;
  report.title = absl::StrJoin(
      maps, " and ", [](std::string* out, const NamedMap& map) { absl::StrAppend(out, map.name); });
  report.subtitle = absl::StrCat("semantic_kiss ", Version());
  for (size_t i = 0; i < maps.size(); ++i) {
    report.maps.push_back(report::ViewOf(maps[i].map, std::move(layers[i]), maps[i].name));
  }
  report.tables = {ContentTable(maps), LabelTable(maps)};
  report.code_heading = "The configuration that made the map";
  report.code = maps.front().map.configuration_lua;
  return report;
}

}  // namespace semantic_kiss::cli
