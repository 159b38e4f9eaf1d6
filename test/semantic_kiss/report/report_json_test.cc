// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/report_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace semantic_kiss::report {
namespace {

using Json = nlohmann::ordered_json;

Report SmallReport() {
  MapView map;
  map.caption = "caption";
  map.layers.frame = {0.2, -10., 20., 300, 200};
  map.layers.halvings = 1;
  map.layers.tile_side_px = 256;
  map.layers.layers = {{"car", "Movable", {1, 16, 255}, {{1, 2, 3, "abc"}}}};
  map.paths = {{"drive", Role::kTrajectory, {{0.123, -0.456}, {1., 2.}}}};
  map.colorings = {{"error", "m", {0.1, std::numeric_limits<double>::quiet_NaN()}}};
  map.closure_facts = {"score"};
  map.closures = {{{1., 2.}, {3., 4.}, true, {"0.5"}}, {{1., 2.}, {3., 4.}, std::nullopt, {"0.6"}}};
  map.rejected_facts = {"why"};
  map.rejected = {{{5., 6.}, {7., 8.}, std::nullopt, {"low overlap"}}};
  Report report;
  report.maps = {map};
  Chart chart;
  chart.kind = Chart::Kind::kColumns;
  chart.heading = "Drift";
  chart.categories = {"100"};
  chart.series = {{"odometry", Role::kOdometry, {0.51234567}}};
  report.charts = {chart};
  return report;
}

TEST(ReportJsonTest, NothingIsEmptyLists) {
  EXPECT_EQ(ReportJson(Report()).dump(), "{\"maps\":[],\"charts\":[]}");
}

TEST(ReportJsonTest, TellsOfMaps) {
  const Json map = ReportJson(SmallReport())["maps"][0];
  EXPECT_EQ(map["caption"], "caption");
  EXPECT_EQ(map["frame"], Json::parse("{\"min_x\": -10.0, \"max_y\": 20.0, \"resolution\": 0.2, "
                                      "\"width\": 300, \"height\": 200}"));
  EXPECT_EQ(map["halvings"], 1);
  EXPECT_EQ(map["tile_side"], 256);
  EXPECT_EQ(map["layers"][0],
            Json::parse("{\"name\": \"car\", \"group\": \"Movable\", \"color\": \"#0110ff\", "
                        "\"tiles\": {\"1/2/3\": \"data:image/png;base64,YWJj\"}}"));
  EXPECT_EQ(map["paths"][0], Json::parse("{\"name\": \"drive\", \"role\": \"trajectory\", "
                                         "\"x\": [0.12, 1.0], \"y\": [-0.46, 2.0]}"));
  EXPECT_EQ(map["colorings"][0]["values"], Json::parse("[0.1, null]"));
  EXPECT_EQ(map["closures"][0], Json::parse("{\"node\": [1.0, 2.0], \"submap\": [3.0, 4.0], "
                                            "\"right\": true, \"facts\": [\"0.5\"]}"));
  EXPECT_TRUE(map["closures"][1]["right"].is_null());
  EXPECT_EQ(map["rejected_facts"], Json::parse("[\"why\"]"));
  EXPECT_EQ(map["rejected"], Json::parse("[{\"node\": [5.0, 6.0], \"submap\": [7.0, 8.0], "
                                         "\"right\": null, \"facts\": [\"low overlap\"]}]"));
}

TEST(ReportJsonTest, TellsOfCharts) {
  const Json chart = ReportJson(SmallReport())["charts"][0];
  EXPECT_EQ(chart["kind"], "columns");
  EXPECT_EQ(chart["categories"][0], "100");
  EXPECT_EQ(chart["series"][0]["role"], "odometry");
  EXPECT_EQ(chart["series"][0]["values"][0], 0.5123);
  EXPECT_EQ(chart["along_path"], false);
}

}  // namespace
}  // namespace semantic_kiss::report
