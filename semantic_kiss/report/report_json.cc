// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/report_json.h"

#include <cmath>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "glog/logging.h"

namespace semantic_kiss::report {
namespace {

using Json = nlohmann::ordered_json;

// Rounded for charts and lines on maps: what digits beyond would tell cannot be seen.
Json Rounded(double value, double digits) {
  if (!std::isfinite(value)) return Json();
  const double scale = std::pow(10., digits);
  return std::round(value * scale) / scale + 0.;  // no negative zero
}

constexpr int kPositionDigits = 2;
constexpr int kValueDigits = 4;

Json Numbers(const std::vector<double>& values, int digits) {
  Json json = Json::array();
  for (const double value : values) json.push_back(Rounded(value, digits));
  return json;
}

Json Point(const Eigen::Vector2d& position) {
  return {Rounded(position.x(), kPositionDigits), Rounded(position.y(), kPositionDigits)};
}

const char* NameOf(Role role) {
  switch (role) {
    case Role::kTrajectory:
      return "trajectory";
    case Role::kOdometry:
      return "odometry";
    case Role::kGroundTruth:
      return "truth";
    case Role::kEarlierDrive:
      return "earlier";
  }
  LOG(FATAL) << "unknown role " << static_cast<int>(role);
}

const char* NameOf(Chart::Kind kind) {
  switch (kind) {
    case Chart::Kind::kLine:
      return "line";
    case Chart::Kind::kColumns:
      return "columns";
    case Chart::Kind::kRows:
      return "rows";
  }
  LOG(FATAL) << "unknown kind " << static_cast<int>(kind);
}

Json LayerJson(const MapLayer& layer) {
  Json tiles = Json::object();
  for (const LayerTile& tile : layer.tiles) {
    tiles[absl::StrCat(tile.level, "/", tile.column, "/", tile.row)] =
        absl::StrCat("data:image/png;base64,", absl::Base64Escape(tile.png));
  }
  const auto& color = layer.color;
  return {{"name", layer.name},
          {"group", layer.group},
          {"color", absl::StrFormat("#%02x%02x%02x", color.red, color.green, color.blue)},
          {"tiles", std::move(tiles)}};
}

Json FrameJson(const cartographer::io::RasterFrame& frame) {
  return {{"min_x", frame.min_x},
          {"max_y", frame.max_y},
          {"resolution", frame.resolution_m},
          {"width", frame.width},
          {"height", frame.height}};
}

Json PathJson(const Path& path) {
  Json x = Json::array(), y = Json::array();
  for (const Eigen::Vector2d& position : path.positions) {
    x.push_back(Rounded(position.x(), kPositionDigits));
    y.push_back(Rounded(position.y(), kPositionDigits));
  }
  return {{"name", path.name}, {"role", NameOf(path.role)}, {"x", x}, {"y", y}};
}

Json ClosuresJson(const std::vector<ClosureMark>& closures) {
  Json json = Json::array();
  for (const ClosureMark& closure : closures) {
    json.push_back({{"node", Point(closure.node)},
                    {"submap", Point(closure.submap)},
                    {"right", closure.right ? Json(*closure.right) : Json()},
                    {"facts", closure.facts}});
  }
  return json;
}

Json MapJson(const MapView& map) {
  Json json = {{"caption", map.caption},
               {"frame", FrameJson(map.layers.frame)},
               {"halvings", map.layers.halvings},
               {"tile_side", map.layers.tile_side_px},
               {"layers", Json::array()},
               {"paths", Json::array()},
               {"colorings", Json::array()},
               {"closure_facts", map.closure_facts},
               {"closures", ClosuresJson(map.closures)},
               {"rejected_facts", map.rejected_facts},
               {"rejected", ClosuresJson(map.rejected)}};
  for (const MapLayer& layer : map.layers.layers) json["layers"].push_back(LayerJson(layer));
  for (const Path& path : map.paths) json["paths"].push_back(PathJson(path));
  for (const Coloring& coloring : map.colorings) {
    json["colorings"].push_back({{"name", coloring.name},
                                 {"unit", coloring.unit},
                                 {"values", Numbers(coloring.values, kValueDigits)}});
  }
  return json;
}

Json ChartJson(const Chart& chart) {
  Json json = {{"kind", NameOf(chart.kind)},
               {"heading", chart.heading},
               {"x_name", chart.x_name},
               {"y_name", chart.y_name},
               {"x", Numbers(chart.x, kPositionDigits)},
               {"categories", chart.categories},
               {"series", Json::array()},
               {"along_path", chart.along_path}};
  for (const Series& series : chart.series) {
    json["series"].push_back({{"name", series.name},
                              {"role", NameOf(series.role)},
                              {"values", Numbers(series.values, kValueDigits)}});
  }
  return json;
}

}  // namespace

Json ReportJson(const Report& report) {
  Json json = {{"maps", Json::array()}, {"charts", Json::array()}};
  for (const MapView& map : report.maps) json["maps"].push_back(MapJson(map));
  for (const Chart& chart : report.charts) json["charts"].push_back(ChartJson(chart));
  return json;
}

}  // namespace semantic_kiss::report
