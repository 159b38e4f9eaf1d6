// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/map_info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::cli {
namespace {

using cartographer::io::MapSummary;
using ::testing::HasSubstr;
using ::testing::Not;

MapSummary SmallMap() {
  MapSummary summary;
  summary.file_bytes = 3 << 20;
  summary.format_version = 2;
  summary.made_by_us = true;
  summary.kinds = {{"submap", 2, 1 << 20, 2 << 20}};
  MapSummary::Trajectory trajectory;
  trajectory.num_nodes = 16;
  trajectory.num_submaps = 2;
  trajectory.first_time = cartographer::common::FromUnixSeconds(100.);
  trajectory.last_time = cartographer::common::FromUnixSeconds(101.5);
  trajectory.length_m = 11.7;
  summary.trajectories = {trajectory};
  summary.num_intra_constraints = 32;
  summary.label_counts = {{5, 6, 7}};
  summary.grid_bounds_m = Eigen::AlignedBox2d(Eigen::Vector2d(-1., -2.), Eigen::Vector2d(3., 4.));
  summary.history = {"semantic_kiss 0.1.0"};
  summary.configuration_lua = "return {}";
  return summary;
}

TEST(MapInfoTest, TextTellsWhatPeopleAskFor) {
  const std::string text = MapInfoText(SmallMap());
  EXPECT_THAT(text, HasSubstr("3.00 MiB, format 2\n"));
  EXPECT_THAT(text, HasSubstr("0: 16 nodes, 2 submaps, 11.7 m, 1.5 s"));
  EXPECT_THAT(text, HasSubstr("32 within submaps, 0 loop closures"));
  EXPECT_THAT(text, HasSubstr("4.0 m x 6.0 m"));
  EXPECT_THAT(text, HasSubstr("semantic_kiss 0.1.0"));
  EXPECT_THAT(text, Not(HasSubstr("cannot be opened")));
}

TEST(MapInfoTest, TextOfAForeignMapSaysSo) {
  MapSummary summary = SmallMap();
  summary.made_by_us = false;
  summary.num_unsupported_submaps = 2;
  const std::string text = MapInfoText(summary);
  EXPECT_THAT(text, HasSubstr("not made by semantic_kiss"));
  EXPECT_THAT(text, HasSubstr("2 submaps; the map cannot be opened"));
  EXPECT_THAT(text, Not(HasSubstr("grid hits")));
}

TEST(MapInfoTest, JsonHoldsTheSame) {
  const nlohmann::ordered_json json = MapInfoJson(SmallMap());
  EXPECT_EQ(json["file_bytes"], 3 << 20);
  EXPECT_EQ(json["trajectories"][0]["nodes"], 16);
  EXPECT_DOUBLE_EQ(json["trajectories"][0]["last_time_s"].get<double>(), 101.5);
  EXPECT_EQ(json["constraints"]["intra"], 32);
  ASSERT_EQ(json["labels"].size(), 1);
  EXPECT_EQ(json["labels"].begin()->at("node_points"), 7);
  EXPECT_EQ(json["grid_bounds_m"]["max"], (std::vector<double>{3., 4.}));
  EXPECT_TRUE(json["node_bounds_m"].is_null()) << "there is no such box";
  EXPECT_EQ(json["records"][0]["count"], 2);
  EXPECT_EQ(json["configuration"], "return {}");
}

TEST(MapInfoTest, SurvivesAnEmptyMap) {
  EXPECT_THAT(MapInfoText(MapSummary()), HasSubstr("0.00 MiB"));
  EXPECT_TRUE(MapInfoJson(MapSummary())["trajectories"].empty());
}

}  // namespace
}  // namespace semantic_kiss::cli
