// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/html_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(HtmlReportTest, ShowsEverythingOnOnePage) {
  Page page;
  page.title = "Title";
  page.subtitle = "Subtitle";
  page.image_png = "abc";
  page.tables = {{"Heading", {"column"}, {{"cell"}}}, {"Bare", {}, {{"one", "two"}}}};
  page.code_heading = "Configuration";
  page.code = "return {\n}";
  const std::string html = Html(page);
  EXPECT_THAT(html, HasSubstr("<title>Title</title>"));
  EXPECT_THAT(html, HasSubstr("Subtitle"));
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,YWJj\""));
  EXPECT_THAT(html, HasSubstr("<tr><th>column</th></tr>\n<tr><td>cell</td></tr>"));
  EXPECT_THAT(html, HasSubstr("<tr><td>one</td><td>two</td></tr>"));
  EXPECT_THAT(html, HasSubstr("<pre>return {\n}</pre>"));
}

TEST(HtmlReportTest, EscapesText) {
  Page page;
  page.title = "<script>";
  page.tables = {{"a & b", {}, {{"\"quoted\" 'text' <b>"}}}};
  page.code = "x < y";
  const std::string html = Html(page);
  EXPECT_THAT(html, Not(HasSubstr("<script>")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(html, HasSubstr("a &amp; b"));
  EXPECT_THAT(html, HasSubstr("&quot;quoted&quot; &#39;text&#39; &lt;b&gt;"));
  EXPECT_THAT(html, HasSubstr("x &lt; y"));
}

TEST(HtmlReportTest, AnEmptyPageHasNoPicture) {
  const std::string html = Html(Page());
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, HasSubstr("</html>\n"));
}

}  // namespace
}  // namespace semantic_kiss::report
