// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/map_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/map_sketch.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::io::proto::RenderOptions;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

report::proto::ReportOptions Options() {
  report::proto::ReportOptions options;
  options.set_max_side_px(100);
  options.set_max_pictures_mb(1.);
  options.set_tile_side_px(64);
  return options;
}

TEST(MapReportTest, TellsWhatIsInAMap) {
  cartographer::map::Map map = MapFromSketch({"RRC"}, 0.5, 2);
  map.history = {"made", "filtered"};
  map.configuration_lua = "return {}";
  const auto report = MapReport({{"a.pbstream", map}}, RenderOptions(), Options());
  ASSERT_TRUE(report.ok()) << report.status();
  EXPECT_EQ(report->title, "a.pbstream");
  EXPECT_EQ(report->code, "return {}");
  ASSERT_EQ(report->maps.size(), 1u);
  EXPECT_EQ(report->maps[0].layers.layers.size(), 2u);
  EXPECT_THAT(report->tables[0].rows, Contains(ElementsAre("submaps", "1")));
  EXPECT_THAT(report->tables[0].rows, Contains(ElementsAre("history", "made; filtered")));
  EXPECT_THAT(report->tables[1].rows,
              ElementsAre(ElementsAre("car", "2"), ElementsAre("road", "4")));
}

TEST(MapReportTest, PutsTwoMapsSideBySide) {
  const auto report =
      MapReport({{"a", MapFromSketch({"RRC"}, 0.5)}, {"b", MapFromSketch({"RR.P"}, 0.5)}},
                RenderOptions(), Options());
  ASSERT_TRUE(report.ok()) << report.status();
  EXPECT_EQ(report->title, "a and b");
  ASSERT_EQ(report->maps.size(), 2u);
  EXPECT_EQ(report->maps[1].caption, "b");
  EXPECT_THAT(report->tables[1].header, ElementsAre("", "a", "b"));
  EXPECT_THAT(report->tables[1].rows,
              ElementsAre(ElementsAre("car", "1", "-"), ElementsAre("road", "2", "2"),
                          ElementsAre("traffic-sign", "-", "1")));
}

TEST(MapReportTest, AMapWithNothingToDrawIsAnError) {
  EXPECT_THAT(MapReport({{"a", EmptyMap()}}, RenderOptions(), Options()).status().message(),
              HasSubstr("nothing to draw"));
}

}  // namespace
}  // namespace semantic_kiss::cli
