// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::report {
namespace {

TEST(HtmlTest, EscapesWhatHtmlWouldRead) {
  EXPECT_EQ(Escaped("a & \"b\" 'c' <d>"), "a &amp; &quot;b&quot; &#39;c&#39; &lt;d&gt;");
  EXPECT_EQ(Escaped(""), "");
}

TEST(HtmlTest, JsonCannotEndItsScript) {
  EXPECT_EQ(JsonForScript("[\"</script><!--\"]"), "[\"\\u003c/script>\\u003c!--\"]");
}

TEST(HtmlTest, FillsTemplates) {
  EXPECT_EQ(FillTemplate("{{a}}-{{b}}-{{a}}", {{"a", "1"}, {"b", "{{a}}"}}), "1-{{a}}-1");
  EXPECT_EQ(FillTemplate("plain } {", {}), "plain } {");
  EXPECT_EQ(FillTemplate("", {}), "");
}

TEST(HtmlTest, BrokenTemplatesAreBugs) {
  EXPECT_DEATH(FillTemplate("{{missing}}", {}), "missing");
  EXPECT_DEATH(FillTemplate("{{open", {}), "without");
}

}  // namespace
}  // namespace semantic_kiss::report
