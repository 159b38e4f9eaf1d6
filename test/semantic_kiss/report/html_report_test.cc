// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/html_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Report SmallReport() {
  Report report;
  report.title = "Title";
  report.subtitle = "Subtitle";
  report.figures = {{"Driven", "3.7", "km", "in an hour"}};
  report.tables = {{"Heading", "Note", {"column"}, {{"cell"}}}, {"Bare", "", {}, {{"one", "two"}}}};
  Chart chart;
  chart.heading = "Height";
  report.charts = {chart};
  report.code_heading = "Configuration";
  report.code = "return {\n}";
  return report;
}

TEST(HtmlReportTest, ShowsEverythingOnOnePage) {
  const std::string html = Html(SmallReport());
  EXPECT_THAT(html, HasSubstr("<title>Title</title>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"subtitle\">Subtitle</p>"));
  EXPECT_THAT(html, HasSubstr("<dt>Driven</dt><dd><b>3.7</b><span class=\"unit\">km</span>"
                              "<small>in an hour</small></dd>"));
  EXPECT_THAT(html, HasSubstr("<h2>Heading</h2><p class=\"note\">Note</p>"));
  EXPECT_THAT(html, HasSubstr("<thead><tr><th scope=\"col\">column</th></tr>\n</thead>"));
  EXPECT_THAT(html, HasSubstr("<tr><td>one</td><td>two</td></tr>"));
  EXPECT_THAT(html, HasSubstr("id=\"chart-0\""));
  EXPECT_THAT(html, HasSubstr("<pre tabindex=\"0\">return {\n}</pre>"));
  EXPECT_THAT(html, HasSubstr("</html>\n"));
}

TEST(HtmlReportTest, TextCannotBecomeMarkup) {
  const std::string evil = "</script><script>alert(1)</script>";
  Report report;
  report.title = report.subtitle = report.code_heading = report.code = evil;
  report.figures = {{evil, evil, evil, evil}};
  report.tables = {{evil, evil, {evil}, {{evil}}}};
  Chart chart;
  chart.heading = chart.note = chart.x_name = evil;
  report.charts = {chart};
  MapView map;
  map.caption = evil;
  report.maps = {map};
  EXPECT_THAT(Html(report), Not(HasSubstr("<script>alert")));
}

TEST(HtmlReportTest, TextThatIsNotUtf8IsSurvived) {
  Report report;
  Chart chart;
  chart.heading = "\xff";
  report.charts = {chart};
  EXPECT_THAT(Html(report), HasSubstr("</html>\n"));
}

TEST(HtmlReportTest, LoadsNothingFromElsewhere) {
  const std::string html = Html(SmallReport());
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(html, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(html, Not(HasSubstr("<link rel=\"stylesheet\"")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

TEST(HtmlReportTest, CarriesTheMapViewersLicence) {
  EXPECT_THAT(Html(Report()), HasSubstr("Copyright (c) 2010-2019, Vladimir Agafonkin"));
}

TEST(HtmlReportTest, TheSameReportGivesTheSameBytes) {
  EXPECT_EQ(Html(SmallReport()), Html(SmallReport()));
}

}  // namespace
}  // namespace semantic_kiss::report
